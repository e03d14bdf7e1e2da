#include <CLI/CLI.hpp>

#include "common/run_tool.h"
#include "preview_options.h"
#include "run_preview.h"

int main(int argc, char** argv) {
    using namespace splitsum;
    CLI::App app(
        "Shows spheres under baked light as an engine draws them: dielectrics and metals from "
        "smooth to\n"
        "rough, or the objects of a file.",
        "splitsum-preview");
    app.footer(
        "Examples: splitsum-preview baked/sunset -o sunset.png\n"
        "          splitsum-preview baked/sunset -o sunset.exr --scene spheres.json --yaw 90\n"
        "          splitsum-preview baked/sunset -o sunset.png --panorama sunset.exr --truth\n"
        "A file of objects:\n"
        "  {\"spheres\": [{\"name\": \"brass\", \"centre\": [0, 0, 0], \"radius\": 0.45,\n"
        "                \"base_color\": [0.9, 0.8, 0.4], \"metalness\": 1, "
        "\"perceptual_roughness\": 0.3}]}\n"
        "centre is [right, up, away]; it is required, the rest is not.");
    const tools::PreviewOptions options(app);
    return tools::run_tool(
        app, argc, argv, [&](Progress& progress) { return tools::run_preview(options, progress); });
}
