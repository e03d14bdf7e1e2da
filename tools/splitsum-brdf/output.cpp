#include "output.h"

#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <vector>

#include "splitsum/assets/table_asset_preview.h"
#include "splitsum/assets/table_asset_source.h"
#include "splitsum/base/atomic_file.h"
#include "splitsum/base/text.h"
#include "splitsum/container/containers.h"
#include "splitsum/png/write_png.h"
#include "splitsum/table/kinds.h"

namespace splitsum::tools {
namespace {

std::vector<std::string_view> endings() {
    std::vector<std::string_view> all;
    for (const Container& container : containers()) all.push_back(container.extension);
    for (const TableSource& source : table_sources()) all.push_back(source.extension);
    return all;
}

Status check_ending(const std::filesystem::path& path, const TableKind& kind) {
    if (table_source_of(path) != nullptr) return ok;
    if (kind.is_closed_form())
        return Error{ErrorKind::bad_argument,
                     cat("'", kind.name, "' is a formula, no texture; it is written as ",
                         join(table_sources(), ", ",
                              [](const TableSource& source) { return source.extension; }),
                         ", got ", path.string())};
    if (container_of(path)) return ok;
    return Error{ErrorKind::bad_argument, cat("no kind of table file ends as ", path.string(),
                                              " does; there are: ", join(endings(), ", "))};
}

Status check_preview(const std::filesystem::path& preview) {
    if (preview.empty()) return ok;
    if (preview.extension() == ".png") return check_writable(preview);
    return Error{ErrorKind::bad_argument, cat("a preview is a .png, got ", preview.string())};
}

}  // namespace

std::string table_endings() {
    const auto all = endings();
    return cat(join(std::span(all).first(all.size() - 1), ", "), " or ", all.back());
}

PreviewOption::PreviewOption(CLI::App& app) {
    app.add_option("--preview", path_, "also a picture of it: the channels as colours and in grey")
        ->option_text("FILE.png")
        ->check(not_empty());
}

Status TableOutput::check(const TablePlan& plan) const {
    const auto kind = kind_of(plan);
    if (!kind) return kind.error();
    if (const Status known = check_ending(path, *kind); !known) return known;
    if (const Status picture = check_preview(preview); !picture) return picture;
    return check_writable(path);
}

PixelFormat TableOutput::format(const TablePlan& plan) const {
    if (encoding.format_given()) return encoding.format();
    const auto kind = kind_of(plan);
    if (!kind) return encoding.format();
    if (table_source_of(path) == nullptr) return default_format(*kind);
    return kind->channels() > 2 ? PixelFormat::rgba32f : PixelFormat::rg32f;
}

Status TableOutput::write(const TableAsset& asset) const {
    const Status written = table_source_of(path) != nullptr
                               ? write_table_source(asset, path)
                               : write_texture(asset.texture, path, encoding.container());
    if (!written || preview.empty()) return written;
    const Preview picture = preview_of(asset.table);
    return write_png(preview, picture.width, picture.height, picture.rgb);
}

void print_table(const TableAsset& asset, const TableOutput& output, bool json) {
    const TableCheck& check = asset.check;
    if (json) {
        nlohmann::ordered_json result{
            {"file", output.path.string()},     {"table", asset.kind.name},
            {"size", asset.plan.size},          {"format", info_of(asset.texture.format).name},
            {"max_abs", check.at_texels},       {"probes", check.texels},
            {"max_abs_between", check.between}, {"points", check.points},
            {"max_abs_in_rim", check.in_rim},   {"rim_points", check.rim_points}};
        if (!output.preview.empty()) result["preview"] = output.preview.string();
        std::cout << result.dump(2) << "\n";
        return;
    }
    std::cout << output.path.string() << ": " << asset.kind.name;
    if (!asset.kind.is_closed_form())
        std::cout << ", " << asset.plan.size << "x" << asset.plan.size << " "
                  << info_of(asset.texture.format).name;
    std::cout << std::scientific << std::setprecision(2) << "; max_abs " << check.at_texels
              << " at " << check.texels << " texels, " << check.between << " at " << check.points
              << " points between them";
    if (check.rim_points > 0)
        std::cout << ", " << check.in_rim << " in the outer half texel (--layout edge has none)";
    std::cout << "\n";
}

}  // namespace splitsum::tools
