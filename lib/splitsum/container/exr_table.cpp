#include "splitsum/container/exr_table.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>

#include <algorithm>

#include "splitsum/base/text.h"
#include "splitsum/container/exr_header_detail.h"
#include "splitsum/container/exr_memory_detail.h"
#include "splitsum/container/file_detail.h"
#include "splitsum/container/limits_detail.h"

namespace splitsum {
namespace {

using Names = std::vector<std::string>;

Status check_table(const TextureAsset& texture) {
    if (Status valid = validate(texture); !valid) return valid;
    const PixelFormatInfo& info = info_of(texture.format);
    const bool is_float = info.format != PixelFormat::rg16unorm;
    if (texture.face_count != 1 || texture.levels.size() != 1 || !holds_tables(info) || !is_float)
        return Error{ErrorKind::bad_argument,
                     cat("a texture of ", info.name, " with ", texture.face_count, " faces and ",
                         texture.levels.size(),
                         " levels is no table; EXR tables are one level of rg16f, rg32f, rgba16f "
                         "or rgba32f")};
    return ok;
}

// The channels of each layer.
std::vector<Names> names_of(int channels, int layers) {
    if (layers == 1) return {exr::channel_names(channels)};
    std::vector<Names> names;
    for (int layer = 0; layer < layers; ++layer)
        names.push_back(exr::channel_names_of_layer(channels, layer));
    return names;
}

Names joined(const std::vector<Names>& layers) {
    Names all;
    for (const Names& names : layers) all.insert(all.end(), names.begin(), names.end());
    return all;
}

bool has_channels(const Imf::Header& header, const Names& names) {
    return std::ranges::all_of(names, [&](const std::string& name) {
        return header.channels().findChannel(name) != nullptr;
    });
}

// What of a file is a table, by its channels.
std::vector<Names> names_in(const Imf::Header& header) {
    int layers = 0;
    while (has_channels(header, exr::channel_names_of_layer(2, layers))) ++layers;
    if (layers < 2) return names_of(has_channels(header, exr::channel_names(4)) ? 4 : 2, 1);
    return names_of(has_channels(header, exr::channel_names_of_layer(4, 0)) ? 4 : 2, layers);
}

Imf::FrameBuffer frame_buffer_of(TextureAsset& texture, const std::vector<Names>& names,
                                 const Imath::Box2i& window) {
    const std::span<std::byte> texels = texture.levels.front();
    const size_t bytes = texels.size() / names.size();
    Imf::FrameBuffer buffer;
    for (size_t layer = 0; layer < names.size(); ++layer) {
        const Imf::FrameBuffer part = exr::frame_buffer_over(texels.subspan(layer * bytes, bytes),
                                                             texture.format, names[layer], window);
        for (auto slice = part.begin(); slice != part.end(); ++slice)
            buffer.insert(slice.name(), slice.slice());
    }
    return buffer;
}

// The texture that those channels of a file make, without texels.
Result<TextureAsset> described_by(const Imf::Header& header, const std::vector<Names>& names) {
    const auto format =
        exr::format_of(header, joined(names), static_cast<int>(names.front().size()));
    if (!format) return format.error();
    const auto size = exr::size_of(header);
    if (!size) return size.error();
    TextureAsset texture;
    texture.format = *format;
    texture.width = size->width;
    texture.height = size->height;
    texture.layer_count = static_cast<int>(names.size());
    texture.metadata = exr::metadata_of(header);
    texture.levels.resize(1);
    if (Status small_enough = check_memory(texture); !small_enough) return small_enough.error();
    return texture;
}

}  // namespace

Result<std::vector<std::byte>> encode_exr_table(const TextureAsset& texture) {
    if (Status valid = check_table(texture); !valid) return valid.error();
    const auto names = names_of(info_of(texture.format).channels, texture.layer_count);
    const auto header = exr::header_for(texture, joined(names), texture.width, texture.height);
    if (!header) return header.error();
    return exr::guarded(ErrorKind::internal, [&]() -> Result<std::vector<std::byte>> {
        exr::MemoryOutput stream;
        {
            TextureAsset copy = texture;  // OpenEXR wants bytes that it could change
            Imf::OutputFile file(stream, *header);
            file.setFrameBuffer(frame_buffer_of(copy, names, header->dataWindow()));
            file.writePixels(texture.height);
        }
        return stream.take();
    });
}

Result<TextureAsset> decode_exr_table(std::span<const std::byte> bytes) {
    const auto header = exr::read_header(bytes);
    if (!header) return header.error();
    const auto names = names_in(*header);
    auto texture = described_by(*header, names);
    if (!texture) return texture.error();
    return exr::guarded(ErrorKind::unreadable_input, [&]() -> Result<TextureAsset> {
        exr::MemoryInput stream(bytes);
        Imf::InputFile file(stream);
        const Imath::Box2i window = header->dataWindow();
        texture->levels[0].resize(bytes_of_level(*texture, 0));
        file.setFrameBuffer(frame_buffer_of(*texture, names, window));
        file.readPixels(window.min.y, window.max.y);
        return std::move(*texture);
    });
}

Status write_exr_table(const TextureAsset& texture, const std::filesystem::path& path) {
    return write_encoded(path, encode_exr_table(texture));
}

Result<TextureAsset> read_exr_table(const std::filesystem::path& path) {
    return read_encoded(path, decode_exr_table);
}

}  // namespace splitsum
