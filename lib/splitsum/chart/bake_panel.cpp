#include "splitsum/chart/bake_panel.h"

#include <algorithm>

#include "splitsum/base/text.h"
#include "splitsum/chart/filter_ladder.h"
#include "splitsum/chart/level_count.h"
#include "splitsum/chart/level_values.h"

namespace splitsum {
namespace {

using Values = Result<std::vector<float>>;

LevelsPlan levels_plan(const ChartPlan& plan, const FilterPlan& filter) {
    LevelsPlan levels;
    levels.specular = SpecularPlan{plan.bake_size, usual_level_count(plan.bake_size), {}};
    levels.irradiance = IrradiancePlan{};
    levels.filter = filter;
    return levels;
}

int probes_a_level(const ChartPlan& plan) { return std::max(1, plan.probes / 4); }

Values values_of(const AssetLevels& levels, const ChartPlan& plan) {
    std::vector<float> values;
    const auto add = [&](const Cubemap& cubemap) {
        add_values_at(cubemap, probe_texels(cubemap.face_size, probes_a_level(plan)), values);
    };
    for (size_t level = 1; level < levels.specular.size(); ++level) add(levels.specular[level]);
    add(*levels.irradiance);
    return values;
}

Values exact_values(const Environment& environment, const ChartPlan& plan, Progress& progress) {
    std::vector<float> values;
    const auto add = [&](const Lobe& lobe, int face_size) {
        add_exact_values(environment, lobe, face_size,
                         probe_texels(face_size, probes_a_level(plan)), values, progress);
    };
    const SpecularPlan specular = *levels_plan(plan, {}).specular;
    const auto roughness = roughness_of_levels(specular.roughness, specular.levels);
    for (int level = 1; level < specular.levels; ++level) {
        const double r = roughness[size_t(level)];
        add({LobeKind::ggx, r * r}, std::max(1, plan.bake_size >> level));
    }
    add({LobeKind::cosine}, IrradiancePlan{}.face_size);
    if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted"};
    return values;
}

// The bake's methods are those that can make all of it.
std::vector<FilterRung> rungs_of(const ChartPlan& plan) {
    const FilterMethod automatic = *find_filter_method("auto", LobeKind::ggx);
    std::vector<FilterRung> rungs = accuracy_ladder(automatic, plan.accuracies);
    for (const FilterRung& rung : filter_ladder(LobeKind::ggx, plan.bake_samples, {}))
        if (rung.method.filters_cosine && rung.name == rung.method.name) rungs.push_back(rung);
    return rungs;
}

}  // namespace

Panel bake_panel(const std::filesystem::path& panorama, const PanoramaOptions& options,
                 const Light& light, const ChartPlan& plan) {
    Panel panel;
    panel.facts = {panorama.stem().string(), "bake", 0,        plan.bake_size, 3,
                   "a whole bake",           "",     "rel_rms"};
    panel.facts.timed =
        cat("Time: reading the file and making ", usual_level_count(plan.bake_size),
            " specular levels from ", plan.bake_size,
            "² down and diffuse light of 32², all anew; not the start of a process, encoding or "
            "writing.");
    for (const FilterRung& rung : rungs_of(plan)) {
        const auto make = [panorama, options, rung, plan](Progress& progress) -> Values {
            const LevelsPlan levels = levels_plan(plan, rung.plan);
            LightUse use;
            use.levels = levels;
            const auto loaded = load_light(panorama, options, use, progress);
            if (!loaded) return loaded.error();
            const auto made = filter_levels(loaded->filter_source(), levels, progress);
            if (!made) return made.error();
            return values_of(*made, plan);
        };
        panel.contestants.push_back({rung.name, rung.effort_name, rung.effort, make});
    }
    panel.reference = [&light, plan](Progress& progress) {
        return exact_values(light.environment, plan, progress);
    };
    return panel;
}

}  // namespace splitsum
