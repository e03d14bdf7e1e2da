#include "splitsum/verify/check_levels.h"

#include <algorithm>

namespace splitsum {

int default_probes(int panorama_height) { return panorama_height <= 1024 ? 8 : 1; }

LevelCheck check_level(const Cubemap& cubemap, const ExactTexels& exact, double stored_factor) {
    std::vector<Vec3> stored;
    for (const auto [face, x, y] : exact.texels)
        stored.push_back(cubemap.at(face, x, y) / float(stored_factor));
    LevelCheck check;
    check.face_size = cubemap.face_size;
    check.figures = error_figures(std::span<const Vec3>(stored), exact.radiance);
    check.mean_radiance = mean_radiance(cubemap) / stored_factor;
    return check;
}

LevelCheck check_diffuse(const Cubemap& cubemap, const ExactTexels& exact, double stored_factor) {
    LevelCheck check = check_level(cubemap, exact, stored_factor);
    check.perceptual_roughness = 1;
    return check;
}

std::vector<LevelCheck> check_chain(std::span<const Cubemap> levels,
                                    std::span<const double> perceptual_roughness,
                                    std::span<const ExactTexels> exact) {
    std::vector<LevelCheck> checks;
    for (size_t level = 0; level < levels.size(); ++level) {
        LevelCheck check =
            check_level(levels[level], level < exact.size() ? exact[level] : ExactTexels());
        check.level = int(level);
        check.perceptual_roughness = perceptual_roughness[level];
        checks.push_back(check);
    }
    return checks;
}

std::vector<ProbedCubemap> probed_chain(int face_size,
                                        std::span<const double> perceptual_roughness) {
    std::vector<ProbedCubemap> cubemaps;
    for (const double r : perceptual_roughness)
        cubemaps.push_back({{LobeKind::ggx, r * r}, std::max(1, face_size >> cubemaps.size())});
    return cubemaps;
}

Result<std::vector<LevelCheck>> check_specular(std::span<const Cubemap> levels,
                                               std::span<const double> perceptual_roughness,
                                               const CheckedAgainst& truth, Progress& progress) {
    if (levels.empty()) return std::vector<LevelCheck>();
    const auto exact = exact_texels(truth.environment, truth.panorama_from_cube,
                                    probed_chain(levels[0].face_size, perceptual_roughness),
                                    truth.probes, progress);
    if (!exact) return exact.error();
    return check_chain(levels, perceptual_roughness, *exact);
}

Result<LevelCheck> check_irradiance(const Cubemap& irradiance, double stored_factor,
                                    const CheckedAgainst& truth, Progress& progress) {
    const ProbedCubemap probed{{LobeKind::cosine}, irradiance.face_size};
    const auto exact = exact_texels(truth.environment, truth.panorama_from_cube, {&probed, 1},
                                    truth.probes, progress);
    if (!exact) return exact.error();
    return check_diffuse(irradiance, exact->front(), stored_factor);
}

Cubemap cubemap_of_harmonics(const IrradianceHarmonics& harmonics, int face_size) {
    Cubemap values(face_size);
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < values.face_size; ++y)
            for (int x = 0; x < values.face_size; ++x)
                values.at(face, x, y) =
                    Vec3(evaluate(harmonics, direction_of_texel(face, x, y, values.face_size)));
    return values;
}

Result<LevelCheck> check_harmonics(const IrradianceHarmonics& harmonics,
                                   const CheckedAgainst& truth, Progress& progress) {
    return check_irradiance(cubemap_of_harmonics(harmonics), 1, truth, progress);
}

}  // namespace splitsum
