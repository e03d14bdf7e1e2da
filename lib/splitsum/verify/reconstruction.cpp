#include "splitsum/verify/reconstruction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "splitsum/sphere/cubemap_lookup.h"
#include "splitsum/verify/all_rows_detail.h"

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

std::vector<ReconstructionProbes::Band> probed_bands(std::span<const RoughnessBand> ranges,
                                                     int count) {
    std::vector<ReconstructionProbes::Band> bands;
    for (const RoughnessBand& range : ranges) {
        bands.push_back({range, {}});
        for (int i = 0; i < count; ++i)
            bands.back().probes.push_back(probe_at(quasirandom_point(i), range));
    }
    return bands;
}

std::vector<ReferenceProbes::Probe> integrals_of(std::span<const ReconstructionProbes::Band> bands,
                                                 const Mat3d& panorama_from_cube) {
    std::vector<ReferenceProbes::Probe> integrals;
    for (const ReconstructionProbes::Band& band : bands)
        for (const Probe& probe : band.probes)
            integrals.push_back(
                {{LobeKind::ggx, probe.perceptual_roughness * probe.perceptual_roughness},
                 panorama_from_cube * probe.towards});
    return integrals;
}

}  // namespace

std::span<const RoughnessBand> roughness_bands() {
    static constexpr std::array<RoughnessBand, 4> bands = {
        {{0, 0.125}, {0.125, 0.25}, {0.25, 0.5}, {0.5, 1}}};
    return bands;
}

ReconstructionRows::ReconstructionRows(int height, const Mat3d& panorama_from_cube,
                                       std::span<const RoughnessBand> bands, int count)
    : bands_(probed_bands(bands, count)),
      count_(count),
      reference_(height, integrals_of(bands_, panorama_from_cube)) {}

ReconstructionProbes ReconstructionRows::finish() && {
    const std::vector<Vec3> exact = reference_.finish();
    size_t next = 0;
    for (ReconstructionProbes::Band& band : bands_)
        for (Probe& probe : band.probes) probe.exact = exact[next++];
    return {std::move(bands_)};
}

Result<ReconstructionProbes> reconstruction_probes(const Environment& environment,
                                                   const Mat3d& panorama_from_cube,
                                                   std::span<const RoughnessBand> bands, int count,
                                                   Progress& progress) {
    ReconstructionRows rows(environment.height(), panorama_from_cube, bands, count);
    const Status added = add_all_rows(rows, rows.probe_count(), environment, progress);
    if (!added) return added.error();
    return std::move(rows).finish();
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
