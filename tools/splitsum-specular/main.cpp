#include <CLI/CLI.hpp>

#include "common/options.h"
#include "common/run_tool.h"
#include "light/cubemap_tool.h"
#include "splitsum/bake/facts.h"
#include "splitsum/filter/methods.h"

int main(int argc, char** argv) {
    using namespace splitsum;
    CLI::App app(
        "Prefilters a panorama for reflections: a cubemap whose mip levels are ever rougher "
        "mirrors.",
        "splitsum-specular");
    app.footer("Example: splitsum-specular sunset.exr -o specular.ktx2 --size 256 --levels 7");
    const tools::InputOptions input(app);
    const tools::SpecularOptions specular(app);
    const tools::OrientationOptions orientation(app);
    const tools::FilterOptions filter(app, tools::methods_for(LobeKind::ggx));
    const tools::EncodingOptions encoding(app, tools::EncodingOptions::Content::cubemap);
    const tools::CubemapOutputOptions output(app, "the mip chain");

    return tools::run_tool(app, argc, argv, [&](Progress& progress) -> Status {
        const auto plan = specular.plan();
        if (!plan) return plan.error();
        const Status possible = output.check({encoding.format(), plan->face_size, plan->levels});
        if (!possible) return possible;
        const LevelsPlan levels_plan{*plan, std::nullopt, filter.plan, orientation.plan};
        const auto light = load_light(input.panorama(), input.plan(),
                                      {.levels = levels_plan, .probes = output.probes()}, progress);
        if (!light) return light.error();

        const auto levels = filter_levels(light->filter_source(), levels_plan, progress);
        if (!levels) return levels.error();
        const auto asset =
            cubemap_asset(levels->specular, encoding.format(),
                          specular_facts(light->source, *plan, filter.plan, orientation.plan));
        if (!asset) return asset.error();
        return output.measure_and_write(*asset, levels->accounts, *light, levels_plan,
                                        encoding.container(), progress);
    });
}
