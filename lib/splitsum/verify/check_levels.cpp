#include "splitsum/verify/check_levels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/filter/reference.h"
#include "splitsum/math/low_discrepancy.h"

namespace splitsum {
namespace {

struct Probe {
    int face, x, y;
};

// Texels spread over all faces: every one of a small level, Hammersley points of a large one, which
// repeat no texel as long as there are far fewer of them than texels.
std::vector<Probe> probes_of(int face_size, int count) {
    std::vector<Probe> probes;
    if (int64_t(face_count) * face_size * face_size <= count) {
        for (int face = 0; face < face_count; ++face)
            for (int y = 0; y < face_size; ++y)
                for (int x = 0; x < face_size; ++x) probes.push_back({face, x, y});
        return probes;
    }
    for (int i = 0; i < count; ++i) {
        const Vec2d point = hammersley(uint32_t(i), uint32_t(count));
        probes.push_back({i % face_count, int(point.x * face_size), int(point.y * face_size)});
    }
    return probes;
}

// The mean radiance over a cube texel, its parts weighted by their solid angles.
Vec3 mean_over_texel(const CheckedAgainst& truth, const Probe& probe, int face_size) {
    constexpr int points = 128;
    Vec3d sum(0);
    double total = 0;
    for (int j = 0; j < points; ++j)
        for (int i = 0; i < points; ++i) {
            const double s = (probe.x + (i + 0.5) / points) / face_size;
            const double t = (probe.y + (j + 0.5) / points) / face_size;
            const double weight =
                std::pow(1 + std::pow(2 * s - 1, 2) + std::pow(2 * t - 1, 2), -1.5);
            const Vec3d d = truth.panorama_from_cube * direction_on_face(probe.face, s, t);
            sum += weight * Vec3d(radiance_towards(truth.environment, d));
            total += weight;
        }
    return Vec3(sum / total);
}

// Compares `values` with exact(i) at every probe, in parallel over probes.
template <class Exact>
Result<ErrorFigures> compare(const std::vector<Vec3>& values, const Exact& exact,
                             Progress& progress) {
    std::vector<Vec3> reference(values.size());
    parallel_rows(int(values.size()), [&](int i) {
        if (progress.cancelled()) return;
        reference[size_t(i)] = exact(size_t(i));
        progress.advance(1);
    });
    if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted while measuring"};
    return error_figures(values, reference);
}

// The figures of a cubemap at the probes against `lobe`, or against the mirror image for alpha 0.
Result<LevelCheck> check_cubemap(const Cubemap& cubemap, const Lobe& lobe,
                                 const CheckedAgainst& truth, Progress& progress) {
    const std::vector<Probe> probes = probes_of(cubemap.face_size, truth.probes);
    std::vector<Vec3> values;
    for (const Probe& p : probes) values.push_back(cubemap.at(p.face, p.x, p.y));

    const bool mirror = lobe.kind == LobeKind::ggx && lobe.alpha == 0;
    const auto reference =
        mirror || probes.empty() ? nullptr : prepare_reference(truth.environment, {&lobe, 1}, {});
    const auto exact = [&](size_t i) {
        const Probe& p = probes[i];
        if (mirror) return mean_over_texel(truth, p, cubemap.face_size);
        const Vec3d towards =
            truth.panorama_from_cube * direction_of_texel(p.face, p.x, p.y, cubemap.face_size);
        Vec3 radiance;
        reference->evaluate(0, {{&towards, 1}}, {&radiance, 1});
        return radiance;
    };
    const auto figures = compare(values, exact, progress);
    if (!figures) return figures.error();
    LevelCheck check;
    check.face_size = cubemap.face_size;
    check.figures = *figures;
    check.mean_radiance = mean_radiance(cubemap);
    return check;
}

}  // namespace

int affordable_probes(const Environment& environment) {
    constexpr double texels_of_64_probes = 2.0 * 512 * 512;
    const double texels = double(environment.width()) * environment.height();
    return std::clamp(int(64 * texels_of_64_probes / texels), 4, 64);
}

Result<std::vector<LevelCheck>> check_specular(std::span<const Cubemap> levels,
                                               std::span<const double> perceptual_roughness,
                                               const CheckedAgainst& truth, Progress& progress) {
    std::vector<LevelCheck> checks;
    for (size_t level = 0; level < levels.size(); ++level) {
        const double r = perceptual_roughness[level];
        auto check = check_cubemap(levels[level], {LobeKind::ggx, r * r}, truth, progress);
        if (!check) return check.error();
        check->level = int(level);
        check->perceptual_roughness = r;
        checks.push_back(*check);
    }
    return checks;
}

Result<LevelCheck> check_irradiance(const Cubemap& irradiance, double stored_factor,
                                    const CheckedAgainst& truth, Progress& progress) {
    Cubemap over_pi = irradiance;
    for (Vec3& texel : over_pi.texels) texel /= float(stored_factor);
    auto check = check_cubemap(over_pi, {LobeKind::cosine}, truth, progress);
    if (check) check->perceptual_roughness = 1;
    return check;
}

Result<LevelCheck> check_harmonics(const IrradianceHarmonics& harmonics,
                                   const CheckedAgainst& truth, Progress& progress) {
    // A cubemap of the series' values makes this the same question as above.
    constexpr int face_size = 16;
    Cubemap values(face_size);
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < face_size; ++y)
            for (int x = 0; x < face_size; ++x)
                values.at(face, x, y) =
                    Vec3(evaluate(harmonics, direction_of_texel(face, x, y, face_size)));
    return check_irradiance(values, 1, truth, progress);
}

}  // namespace splitsum
