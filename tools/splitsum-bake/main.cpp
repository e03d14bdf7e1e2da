#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "common/run_tool.h"
#include "process_memory.h"
#include "run_bake.h"

int main(int argc, char** argv) {
    using namespace splitsum;
    tools::return_freed_memory();
    CLI::App app(
        "Bakes the image-based lighting of panoramas: reflections, diffuse light, the split-sum "
        "table\n"
        "and a report of measured errors. What is up to date is not baked again.",
        "splitsum-bake");
    app.footer(
        "Makes DIR/<panorama>/{specular.ktx2, irradiance.ktx2, harmonics.json, contact.png,\n"
        "report.json, report.txt} for each panorama, and DIR/brdf.ktx2.\n"
        "Examples: splitsum-bake sunset.exr studio.hdr -o baked --size 512 --levels 8\n"
        "          splitsum-bake hdri --exclude 'old/*' -o baked --cache ~/.cache/splitsum\n"
        "          splitsum-bake --manifest bake.toml -o baked --dry-run");
    const tools::BakeOptions options(app);
    const std::vector<std::string> command(argv, argv + argc);
    return tools::run_tool(app, argc, argv, [&](Progress& progress) {
        return tools::run_bake(app, options, command, progress);
    });
}
