#include "splitsum/chart/level_panels.h"

#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/chart/filter_ladder.h"
#include "splitsum/chart/level_values.h"
#include "splitsum/filter/filter_cubemap.h"
#include "splitsum/filter/gaussians.h"
#include "splitsum/filter/irradiance_harmonics.h"

namespace splitsum {
namespace {

using Values = Result<std::vector<float>>;

const Mat3d along_the_axes(1.0);

Values values_of(const Cubemap& cubemap, const ChartPlan& plan) {
    std::vector<float> values;
    add_values_at(cubemap, probe_texels(cubemap.face_size, plan.probes), values);
    return values;
}

Contestant contestant_of(const NamedLight& light, const Lobe& lobe, const FilterRung& rung,
                         const ChartPlan& plan) {
    const auto make = [&light, lobe, rung, plan](Progress& progress) -> Values {
        const auto filter = rung.method.prepare(light.source, {&lobe, 1}, rung.plan);
        const auto level = filter_cubemap(*filter, 0, plan.level_size, along_the_axes, 0, progress);
        if (!level) return level.error();
        return values_of(level->cubemap, plan);
    };
    return {rung.name, rung.effort_name, rung.effort, make};
}

// A cubemap of what a renderer evaluates at every normal.
template <class Irradiance>
Cubemap cubemap_of(int face_size, const Irradiance& irradiance) {
    Cubemap cubemap(face_size);
    parallel_rows(face_count * face_size, [&](int row) {
        const int face = row / face_size, y = row % face_size;
        for (int x = 0; x < face_size; ++x)
            cubemap.at(face, x, y) = Vec3(irradiance(direction_of_texel(face, x, y, face_size)));
    });
    return cubemap;
}

Contestant harmonics_of_order(const NamedLight& light, int order, bool windowed,
                              const ChartPlan& plan) {
    const auto make = [&light, order, windowed, plan](Progress&) -> Values {
        const auto harmonics = irradiance_harmonics(light.source, order, windowed, along_the_axes);
        return values_of(
            cubemap_of(plan.level_size,
                       [&](const Vec3d& normal) { return evaluate(harmonics, normal); }),
            plan);
    };
    return {windowed ? "harmonics (windowed)" : "harmonics", "order", double(order), make};
}

Contestant gaussians_of_count(const NamedLight& light, int count, const ChartPlan& plan) {
    const auto make = [&light, count, plan](Progress&) -> Values {
        const SphericalGaussians gaussians = fit_gaussians(light.source, count, along_the_axes);
        const auto irradiance = [&](const Vec3d& normal) {
            return irradiance_over_pi(gaussians, normal);
        };
        return values_of(cubemap_of(plan.level_size, irradiance), plan);
    };
    return {"spherical Gaussians", "lobes", double(count), make};
}

Panel panel_of(const NamedLight& light, const Lobe& lobe, const ChartPlan& plan) {
    Panel panel;
    panel.facts.panorama = light.name;
    panel.facts.size = plan.level_size;
    panel.facts.timed = cat("Time: preparing the method for this lobe and filtering a cubemap of ",
                            plan.level_size, "² texels a face, from a panorama in memory.");
    for (const FilterRung& rung : filter_ladder(lobe.kind, plan.samples, plan.accuracies))
        panel.contestants.push_back(contestant_of(light, lobe, rung, plan));
    const auto probes = probe_texels(plan.level_size, plan.probes);
    panel.reference = [&light, lobe, plan, probes](Progress& progress) -> Values {
        std::vector<float> values;
        add_exact_values(light.source.environment, lobe, plan.level_size, probes, values, progress);
        if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted"};
        return values;
    };
    panel.whole_over_probes =
        double(face_count) * plan.level_size * plan.level_size / double(probes.size());
    return panel;
}

}  // namespace

std::vector<Panel> specular_panels(const NamedLight& light, const ChartPlan& plan) {
    std::vector<Panel> panels;
    for (const double r : plan.perceptual_roughness) {
        Panel panel = panel_of(light, {LobeKind::ggx, r * r}, plan);
        panel.facts.asset = "specular";
        panel.facts.perceptual_roughness = r;
        panel.facts.title = cat("reflections, roughness ", r);
        panels.push_back(std::move(panel));
    }
    return panels;
}

Panel diffuse_panel(const NamedLight& light, const ChartPlan& plan) {
    Panel panel = panel_of(light, {LobeKind::cosine}, plan);
    panel.facts.asset = "diffuse";
    panel.facts.title = "diffuse light";
    for (const bool windowed : {false, true})
        for (const int order : plan.harmonics_orders)
            panel.contestants.push_back(harmonics_of_order(light, order, windowed, plan));
    for (const int count : plan.gaussian_counts)
        panel.contestants.push_back(gaussians_of_count(light, count, plan));
    return panel;
}

}  // namespace splitsum
