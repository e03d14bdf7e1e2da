#include <CLI/CLI.hpp>

#include "common/run_tool.h"
#include "measuring.h"

int main(int argc, char** argv) {
    using namespace splitsum;
    CLI::App app(
        "Charts speed against accuracy: every method of every asset, at rising effort, under the\n"
        "light of panoramas, against exact integration.",
        "splitsum-chart");
    app.footer(
        "Makes DIR/{chart.html, chart.png, chart.svg, storage.png, storage.svg, chart.csv,\n"
        "storage.csv, chart.json, chart.gnuplot}; the pictures need gnuplot. Takes a few minutes "
        "for\n"
        "each panorama of 1024 x 512. Interrupted, it writes what was measured until then.\n"
        "Example: splitsum-chart sunset.exr -o chart --quick");
    const tools::ChartOptions chart(app);
    return tools::run_tool(app, argc, argv,
                           [&](Progress& progress) { return tools::run_chart(chart, progress); });
}
