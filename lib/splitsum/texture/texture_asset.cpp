#include "splitsum/texture/texture_asset.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(float));

std::span<const float> floats_of(const std::vector<Vec3>& texels) {
    return {texels.empty() ? nullptr : &texels.front().x, 3 * texels.size()};
}
std::span<float> floats_of(std::vector<Vec3>& texels) {
    return {texels.empty() ? nullptr : &texels.front().x, 3 * texels.size()};
}
std::vector<std::byte> encoded(PixelFormat format, int channels, std::span<const float> values,
                               EncodeCounts& counts) {
    const auto stride = static_cast<size_t>(info_of(format).bytes_per_texel);
    std::vector<std::byte> bytes(values.size() / static_cast<size_t>(channels) * stride);
    counts += encode_texels(format, channels, values, bytes);
    return bytes;
}

std::string kind_of(const TextureAsset& texture) {
    const bool is_array = texture.layer_count != 1;
    return cat(texture.face_count == 6 ? "a cubemap"
               : is_array              ? "a 2D array"
                                       : "a 2D texture",
               " of ", info_of(texture.format).name, " texels");
}

}  // namespace

size_t bytes_of_level(const TextureAsset& texture, int level) {
    const auto width = static_cast<size_t>(std::max(1, texture.width >> level));
    const auto height = static_cast<size_t>(std::max(1, texture.height >> level));
    return width * height * static_cast<size_t>(texture.face_count) *
           static_cast<size_t>(texture.layer_count) *
           static_cast<size_t>(info_of(texture.format).bytes_per_texel);
}

int full_level_count(int width, int height) {
    return std::bit_width(static_cast<unsigned>(std::max(width, height)));
}

Status validate(const TextureAsset& texture) {
    const auto bad = [&](const auto&... what) {
        return Error{
            ErrorKind::bad_argument,
            cat("a texture of ", texture.width, "x", texture.height, " texels, ",
                texture.face_count, " faces and ", texture.levels.size(), " levels ", what...)};
    };
    if (texture.width < 1 || texture.height < 1) return bad("needs a size of at least 1x1");
    if (texture.face_count != 1 && texture.face_count != face_count)
        return bad("needs 1 or 6 faces");
    if (texture.layer_count < 1 || (texture.layer_count > 1 && texture.face_count != 1))
        return bad("and ", texture.layer_count,
                   " layers needs at least one layer, and of a cubemap no more");
    if (texture.face_count == face_count && texture.width != texture.height)
        return bad("needs square faces to be a cubemap");
    const int most = full_level_count(texture.width, texture.height);
    if (texture.levels.empty() || texture.levels.size() > static_cast<size_t>(most))
        return bad("needs 1 to ", most, " levels");
    for (int level = 0; level < static_cast<int>(texture.levels.size()); ++level) {
        const size_t found = texture.levels[static_cast<size_t>(level)].size();
        const size_t needed = bytes_of_level(texture, level);
        if (found != needed)
            return bad("needs ", needed, " bytes in level ", level, ", got ", found);
    }
    return ok;
}

TextureAsset texture_from_cubemaps(std::span<const Cubemap> levels, PixelFormat format,
                                   std::vector<EncodeCounts>& counts) {
    assert(!levels.empty() && holds_colours(info_of(format)));
    TextureAsset texture;
    texture.format = format;
    texture.width = texture.height = levels.front().face_size;
    texture.face_count = face_count;
    for (const Cubemap& level : levels) {
        assert(level.face_size == std::max(1, texture.width >> texture.levels.size()));
        texture.levels.push_back(
            encoded(format, 3, floats_of(level.texels), counts.emplace_back()));
    }
    return texture;
}

TextureAsset texture_from_table(const Table& table, PixelFormat format, EncodeCounts& counts) {
    assert(holds_tables(info_of(format)) && info_of(format).channels >= table.channels);
    TextureAsset texture;
    texture.format = format;
    texture.width = table.width;
    texture.height = table.height;
    texture.layer_count = table.layers;
    texture.levels.push_back(encoded(format, table.channels, table.values, counts));
    return texture;
}

Result<std::vector<Cubemap>> cubemaps_of(const TextureAsset& texture) {
    if (texture.face_count != face_count || !holds_colours(info_of(texture.format)))
        return Error{ErrorKind::unusable_input,
                     cat("a cubemap of colours is needed; this is ", kind_of(texture))};
    std::vector<Cubemap> cubemaps;
    for (size_t level = 0; level < texture.levels.size(); ++level) {
        Cubemap& cubemap = cubemaps.emplace_back(std::max(1, texture.width >> level));
        decode_texels(texture.format, 3, texture.levels[level], floats_of(cubemap.texels));
    }
    return cubemaps;
}

Result<Table> table_of(const TextureAsset& texture) {
    const PixelFormatInfo& info = info_of(texture.format);
    if (texture.face_count != 1 || !holds_tables(info) || texture.levels.empty())
        return Error{ErrorKind::unusable_input,
                     cat("a table is needed; this is ", kind_of(texture))};
    Table table = blank_table(texture.width, texture.height, info.channels, texture.layer_count);
    decode_texels(texture.format, info.channels, texture.levels.front(), table.values);
    return table;
}

}  // namespace splitsum
