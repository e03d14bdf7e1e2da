#include <CLI/CLI.hpp>

#include "batch.h"
#include "common/run_tool.h"
#include "process_memory.h"

int main(int argc, char** argv) {
    using namespace splitsum;
    tools::return_freed_memory();
    CLI::App app(
        "Bakes the image-based lighting of panoramas: reflections, diffuse light, the split-sum "
        "table\n"
        "and a report of measured errors.",
        "splitsum-bake");
    app.footer(
        "Makes DIR/<panorama>/{specular.ktx2, irradiance.ktx2, harmonics.json, contact.png,\n"
        "report.json, report.txt} for each panorama, and DIR/brdf.ktx2.\n"
        "Example: splitsum-bake sunset.exr studio.hdr -o baked --size 512 --levels 8");
    const tools::BatchOptions options(app);
    return tools::run_tool(app, argc, argv,
                           [&](Progress& progress) { return tools::run_batch(options, progress); });
}
