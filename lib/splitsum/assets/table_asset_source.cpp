#include "splitsum/assets/table_asset_source.h"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "splitsum/assets/table_source_detail.h"
#include "splitsum/base/atomic_file.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

using Json = nlohmann::ordered_json;

std::string as_json(const TableAsset& asset) {
    const Table& table = asset.table;
    Json file;
    file["asset"] = "table";
    for (const char* key : {"splitsum.value", "splitsum.axes"})
        file[std::string(key).substr(std::string("splitsum.").size())] =
            asset.texture.metadata.at(key);
    file["metadata"] = asset.texture.metadata;
    if (asset.kind.is_closed_form()) {
        file["formula"] = formula_json(asset);
        return file.dump(2) + "\n";
    }
    file["width"] = table.width;
    file["height"] = table.height;
    file["channels"] = table.channels;
    file["layers"] = table.layers;
    file["channel_names"] = asset.kind.channel_names;
    file["order"] = "layer, row, column, channel";
    // Nine digits bring a float back; a double's digits of it would be twice as many.
    std::string values = "[";
    for (size_t i = 0; i < table.values.size(); ++i)
        values += cat(i == 0 ? "" : i % 8 == 0 ? ",\n    " : ", ", float_text(table.values[i]));
    std::string text = file.dump(2);
    text.resize(text.rfind('\n'));  // before the last brace
    return cat(text, ",\n  \"values\": ", values, "]\n}\n");
}

constexpr TableSource sources[] = {
    {".hpp", "C++17 without dependencies: the numbers and a bilinear lookup", 8192 * 8192,
     table_as_cpp},
    {".glsl", "GLSL 4.50 and ES 3.00, up to 64 x 64 texels: an array and a bilinear lookup",
     64 * 64, table_as_glsl},
    {".json", "the numbers and everything the metadata says", 8192 * 8192, as_json},
};

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    return text;
}

}  // namespace

std::span<const TableSource> table_sources() { return sources; }

const TableSource* table_source_of(const std::filesystem::path& path) {
    const auto found =
        std::ranges::find(sources, lower_case(path.extension().string()), &TableSource::extension);
    return found == std::end(sources) ? nullptr : found;
}

Status write_table_source(const TableAsset& asset, const std::filesystem::path& path) {
    const TableSource* source = table_source_of(path);
    if (source == nullptr)
        return Error{ErrorKind::bad_argument,
                     cat("a table is not written as source to ", path.string(), "; there are: ",
                         join(sources, ", ", [](const TableSource& s) { return s.extension; }))};
    if (!asset.kind.is_closed_form() &&
        asset.table.width * asset.table.height > source->most_texels)
        return Error{ErrorKind::bad_argument,
                     cat(source->extension, " holds tables up to ", source->most_texels,
                         " texels, got ", asset.table.width, "x", asset.table.height,
                         "; a smaller --size works, and .hpp and .json take any")};
    return write_text_whole(path, source->text(asset));
}

}  // namespace splitsum
