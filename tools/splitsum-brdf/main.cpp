#include <CLI/CLI.hpp>

#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>

#include "common/options.h"
#include "common/run_tool.h"
#include "splitsum/assets/table_asset.h"
#include "splitsum/base/atomic_file.h"
#include "splitsum/container/containers.h"

namespace splitsum {
namespace {

void print_result(const TableAsset& asset, const std::filesystem::path& path, bool json) {
    if (json)
        std::cout << nlohmann::ordered_json{{"file", path.string()},
                                            {"max_abs", asset.check.at_texels},
                                            {"probes", asset.check.texels}}
                         .dump(2)
                  << "\n";
    else
        std::cout << path.string() << ": max_abs " << std::scientific << std::setprecision(2)
                  << asset.check.at_texels << " at " << asset.check.texels << " probe texels\n";
}

}  // namespace
}  // namespace splitsum

int main(int argc, char** argv) {
    using namespace splitsum;
    CLI::App app(
        "Bakes the split-sum table: scale and bias of F0 over (n.v, perceptual roughness).",
        "splitsum-brdf");
    app.footer("Example: splitsum-brdf -o brdf.ktx2 --size 256");
    const tools::TableOptions table(app);
    const tools::EncodingOptions encoding(app, tools::EncodingOptions::Content::table);
    const tools::OutputOptions output(app, "FILE", "the table as " + tools::container_endings());
    const tools::JsonOption json(app);

    return tools::run_tool(app, argc, argv, [&](Progress& progress) -> Status {
        const auto container = container_of(output.path());  // before the work, not after it
        if (!container) return container.error();
        if (const Status possible = check_writable(output.path()); !possible) return possible;
        const auto asset = bake_table(table.plan(), encoding.format(), progress);
        if (!asset) return asset.error();
        const Status written =
            container->write(asset->texture, output.path(), encoding.container());
        if (written) print_result(*asset, output.path(), json.json);
        return written;
    });
}
