#include "splitsum/verify/reconstruction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/filter/reference.h"
#include "splitsum/sphere/cubemap_lookup.h"

namespace splitsum {
namespace {

using Probe = ReconstructionProbes::Probe;

// Point i of the additive sequence whose steps are powers of 1 / g, g^4 = g + 1.
Vec3d quasirandom_point(int i) {
    constexpr double g = 1.2207440846057596;
    const auto coordinate = [&](double step) {
        const double at = 0.5 + (i + 1) * step;
        return at - std::floor(at);
    };
    return {coordinate(1 / g), coordinate(1 / (g * g)), coordinate(1 / (g * g * g))};
}

Probe probe_at(const Vec3d& point, const RoughnessBand& range) {
    const double y = 1 - 2 * point.x;
    const double across = std::sqrt((1 - y) * (1 + y));
    const double azimuth = 2 * std::numbers::pi * point.y;
    const double inside = std::clamp(point.z, 1e-6, 1 - 1e-6);
    return {{across * std::sin(azimuth), y, across * std::cos(azimuth)},
            range.from + (range.to - range.from) * inside,
            Vec3(0)};
}

Vec3 exact_integral(const Environment& environment, const Mat3d& panorama_from_cube,
                    const Probe& probe) {
    const double r = probe.perceptual_roughness;
    const Lobe lobe{LobeKind::ggx, r * r};
    const Vec3d towards = panorama_from_cube * probe.towards;
    Vec3 radiance;
    prepare_reference(environment, {&lobe, 1}, {})->evaluate(0, {{&towards, 1}}, {&radiance, 1});
    return radiance;
}

}  // namespace

std::span<const RoughnessBand> roughness_bands() {
    static constexpr std::array<RoughnessBand, 4> bands = {
        {{0, 0.125}, {0.125, 0.25}, {0.25, 0.5}, {0.5, 1}}};
    return bands;
}

Result<ReconstructionProbes> reconstruction_probes(const Environment& environment,
                                                   const Mat3d& panorama_from_cube,
                                                   std::span<const RoughnessBand> bands, int count,
                                                   Progress& progress) {
    ReconstructionProbes result;
    for (const RoughnessBand& range : bands) {
        std::vector<Probe> probes(size_t(std::max(count, 0)));
        parallel_rows(int(probes.size()), [&](int i) {
            if (progress.cancelled()) return;
            Probe& probe = probes[size_t(i)];
            probe = probe_at(quasirandom_point(i), range);
            probe.exact = exact_integral(environment, panorama_from_cube, probe);
            progress.advance(1);
        });
        if (progress.cancelled())
            return Error{ErrorKind::interrupted, "interrupted while measuring"};
        result.bands.push_back({range, std::move(probes)});
    }
    return result;
}

Vec3 trilinear_lookup(std::span<const Cubemap> levels, const RoughnessCurve& curve,
                      const Vec3d& direction, double perceptual_roughness) {
    const double level = level_of_roughness(curve, int(levels.size()), perceptual_roughness);
    const size_t finer = std::min(size_t(level), levels.size() - 1);
    const size_t coarser = std::min(finer + 1, levels.size() - 1);
    const float blend = float(level - double(finer));
    return (1 - blend) * bilinear_lookup(levels[finer], direction) +
           blend * bilinear_lookup(levels[coarser], direction);
}

std::vector<ReconstructionError> reconstruction_error(std::span<const Cubemap> levels,
                                                      const RoughnessCurve& curve,
                                                      const ReconstructionProbes& probes) {
    std::vector<ReconstructionError> errors;
    for (const ReconstructionProbes::Band& band : probes.bands) {
        std::vector<Vec3> read, exact;
        for (const Probe& probe : band.probes) {
            read.push_back(
                trilinear_lookup(levels, curve, probe.towards, probe.perceptual_roughness));
            exact.push_back(probe.exact);
        }
        errors.push_back({band.range, error_figures(read, exact)});
    }
    return errors;
}

}  // namespace splitsum
