#include <CLI/CLI.hpp>

#include "common/run_tool.h"
#include "comparison.h"

int main(int argc, char** argv) {
    using namespace splitsum;
    CLI::App app(
        "Measures an asset against exact integration of its panorama, against another asset, or "
        "checks\n"
        "it against the certificate that it carries.",
        "splitsum-compare");
    app.footer(
        "Examples: splitsum-compare specular.ktx2 --panorama sunset.exr --limit rel_rms=0.01\n"
        "          splitsum-compare specular.ktx2\n"
        "          splitsum-compare new/brdf.ktx2 old/brdf.ktx2 --limit max_abs=1e-3");
    const tools::CompareOptions options(app);
    return tools::run_tool(
        app, argc, argv, [&](Progress& progress) { return tools::run_compare(options, progress); });
}
