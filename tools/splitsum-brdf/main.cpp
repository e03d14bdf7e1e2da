#include <CLI/CLI.hpp>

#include "common/options.h"
#include "common/run_tool.h"
#include "output.h"
#include "splitsum/assets/table_asset.h"

int main(int argc, char** argv) {
    using namespace splitsum;
    CLI::App app(
        "Bakes a table that a renderer looks up instead of integrating over microfacets, and "
        "measures it.",
        "splitsum-brdf");
    app.footer(
        "Examples:\n"
        "  splitsum-brdf -o brdf.ktx2 --size 256\n"
        "  splitsum-brdf -o brdf.ktx2 --layout edge --accuracy 0.01 --size auto\n"
        "  splitsum-brdf -o brdf.glsl --table ggx-fit");
    const tools::TableOptions table(app);
    const tools::EncodingOptions encoding(app, tools::EncodingOptions::Content::table);
    const tools::OutputOptions output(app, "FILE", "the table as " + tools::table_endings());
    const tools::PreviewOption preview(app);
    const tools::JsonOption json(app);

    return tools::run_tool(app, argc, argv, [&](Progress& progress) -> Status {
        const tools::TableOutput target{output.path(), preview.path(), encoding};
        if (const Status possible = target.check(table.plan()); !possible) return possible;
        const auto asset = bake_table(table.plan(), target.format(table.plan()), progress);
        if (!asset) return asset.error();
        const Status written = target.write(*asset);
        if (written) tools::print_table(*asset, target, json.json);
        return written;
    });
}
