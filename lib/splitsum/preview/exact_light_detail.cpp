#include "splitsum/preview/exact_light_detail.h"

#include <algorithm>

#include "splitsum/filter/reference_probes.h"
#include "splitsum/filter/spectral.h"
#include "splitsum/verify/all_rows_detail.h"

namespace splitsum {
namespace {

std::vector<double> alphas_of(const Scene& scene) {
    std::vector<double> alphas;
    for (const Sphere& sphere : scene.spheres)
        if (alpha_of(sphere.material) > 0) alphas.push_back(alpha_of(sphere.material));
    std::ranges::sort(alphas);
    alphas.erase(std::ranges::unique(alphas).begin(), alphas.end());
    return alphas;
}

bool is_diffuse(const Surface& surface) { return surface.response.diffuse_albedo != Vec3d(0); }

// What a mirror shows.
Vec3 unfiltered(const Environment& environment, const Surface& surface) {
    return radiance_towards(environment, mirrored_view(surface));
}

}  // namespace

ExactLight::ExactLight(const Environment& environment, const Scene& scene)
    : environment_(environment), alphas_(alphas_of(scene)) {
    std::vector<Lobe> lobes = {{LobeKind::cosine}};
    for (const double alpha : alphas_) lobes.push_back({LobeKind::ggx, alpha});
    FilterPlan plan;
    plan.accuracy = 1e-5;  // the best that a plan allows
    filter_ = prepare_spectral(FilterSource(environment), lobes, plan);
}

std::vector<SplitLight> ExactLight::at(std::span<const Surface> surfaces) const {
    std::vector<SplitLight> light(surfaces.size());
    std::vector<Vec3d> mirrored, normals;
    for (const Surface& surface : surfaces) {
        mirrored.push_back(mirrored_view(surface));
        normals.push_back(surface.frame.normal);
    }
    const double alpha = surfaces.empty() ? 0 : surfaces.front().alpha;
    std::vector<Vec3> specular, diffuse = filtered({LobeKind::cosine}, normals);
    if (alpha > 0) specular = filtered({LobeKind::ggx, alpha}, mirrored);
    for (size_t i = 0; i < surfaces.size(); ++i)
        light[i] = {alpha > 0 ? specular[i] : unfiltered(environment_, surfaces[i]), diffuse[i]};
    return light;
}

std::vector<Vec3> ExactLight::filtered(const Lobe& lobe, const std::vector<Vec3d>& towards) const {
    size_t index = 0;
    if (lobe.kind == LobeKind::ggx)
        index = 1 + size_t(std::ranges::find(alphas_, lobe.alpha) - alphas_.begin());
    std::vector<Vec3> light(towards.size());
    filter_->evaluate(index, {towards, 0}, light);
    for (Vec3& radiance : light) radiance = max(radiance, Vec3(0));  // a series can end below
    return light;
}

Result<std::vector<SplitLight>> reference_light(const Environment& environment,
                                                std::span<const Surface> surfaces,
                                                Progress& progress) {
    std::vector<ReferenceProbes::Probe> probes;
    for (const Surface& surface : surfaces) {
        if (surface.alpha > 0)
            probes.push_back({{LobeKind::ggx, surface.alpha}, mirrored_view(surface)});
        if (is_diffuse(surface)) probes.push_back({{LobeKind::cosine}, surface.frame.normal});
    }
    ReferenceProbes reference(environment.height(), probes);
    const Status added = add_all_rows(reference, int(probes.size()), environment, progress);
    if (!added) return added.error();
    const std::vector<Vec3> integrals = reference.finish();
    auto next = integrals.begin();
    std::vector<SplitLight> light;
    for (const Surface& surface : surfaces) {
        const Vec3 specular = surface.alpha > 0 ? *next++ : unfiltered(environment, surface);
        light.push_back({specular, is_diffuse(surface) ? *next++ : Vec3(0)});
    }
    return light;
}

}  // namespace splitsum
