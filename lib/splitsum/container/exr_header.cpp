#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVersion.h>
#include <OpenEXR/ImfXdr.h>

#include <algorithm>
#include <cstring>

#include "splitsum/base/text.h"
#include "splitsum/container/exr_header_detail.h"
#include "splitsum/container/exr_memory_detail.h"
#include "splitsum/container/limits_detail.h"

namespace splitsum::exr {
namespace {

constexpr const char* names[] = {"R", "G", "B", "A"};

bool holds_halfs(PixelFormat format) {
    return format == PixelFormat::rgba16f || format == PixelFormat::rg16f;
}

bool holds_alpha(PixelFormat format) {
    return format == PixelFormat::rgba16f || format == PixelFormat::rgba32f;
}

size_t bytes_of_channel(PixelFormat format) { return holds_halfs(format) ? 2 : 4; }

Imf::PixelType type_of(PixelFormat format) { return holds_halfs(format) ? Imf::HALF : Imf::FLOAT; }

// Opening a file makes a table of its tiles; the file holds 8 bytes for each of them.
Status check_tiles(const Imf::Header& header, size_t file_size) {
    if (!header.hasTileDescription()) return ok;
    const Imath::Box2i& window = header.dataWindow();
    const auto along = [](int64_t pixels, uint32_t tile) { return (pixels + tile - 1) / tile; };
    const auto columns =
        along(int64_t{window.max.x} - window.min.x + 1, header.tileDescription().xSize);
    const auto rows =
        along(int64_t{window.max.y} - window.min.y + 1, header.tileDescription().ySize);
    if (columns > static_cast<int64_t>(file_size / 8) / rows)
        return Error{ErrorKind::unreadable_input,
                     cat("it states ", columns, "x", rows, " tiles, which ", file_size,
                         " bytes cannot hold")};
    return ok;
}

Result<int> read_version(MemoryInput& stream) {
    int magic = 0, version = 0;
    Imf::Xdr::read<Imf::StreamIO>(stream, magic);
    Imf::Xdr::read<Imf::StreamIO>(stream, version);
    if (magic != Imf::MAGIC)
        return Error{ErrorKind::unreadable_input, "it does not begin as an EXR file does"};
    if (Imf::getVersion(version) != Imf::EXR_VERSION || !Imf::supportsFlags(Imf::getFlags(version)))
        return Error{ErrorKind::unreadable_input,
                     cat("its EXR version word is ", version, ", which OpenEXR does not know")};
    if (Imf::isMultiPart(version) || Imf::isNonImage(version))
        return Error{ErrorKind::unusable_input,
                     "it has several or deep parts; usable are EXR files of a single image"};
    return version;
}

}  // namespace

std::vector<std::string> channel_names(int channels) { return {names, names + channels}; }

std::vector<std::string> channel_names_of_layer(int channels, int layer) {
    std::vector<std::string> of_layer;
    for (int c = 0; c < channels; ++c) of_layer.push_back(cat("layer", layer, ".", names[c]));
    return of_layer;
}

Result<Imf::Header> header_for(const TextureAsset& texture,
                               const std::vector<std::string>& channels, int width, int height) {
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const std::string& name : channels)
        header.channels().insert(name, Imf::Channel(type_of(texture.format)));
    for (const auto& [key, value] : texture.metadata) {
        if (key.starts_with("KTX")) continue;  // speaks about another container
        if (key.empty() || key.size() > 255 || key.find('\0') != std::string::npos ||
            header.find(key) != header.end() || key == "tiles" || key == "envmap" ||
            key == "type" || key == "name" || key == "version" || key == "chunkCount")
            return Error{ErrorKind::bad_argument, cat("the metadata key \"", key,
                                                      "\" cannot be an attribute of an EXR file")};
        header.insert(key, Imf::StringAttribute(value));
    }
    return header;
}

Result<Imf::Header> read_header(std::span<const std::byte> file) {
    return guarded(ErrorKind::unreadable_input, [&]() -> Result<Imf::Header> {
        MemoryInput stream(file);
        const auto read = read_version(stream);
        if (!read) return read.error();
        int version = *read;
        Imf::Header header;
        header.readFrom(stream, version);
        header.sanityCheck(Imf::isTiled(version));
        if (Status tiles = check_tiles(header, file.size()); !tiles) return tiles.error();
        return header;
    });
}

Result<Size> size_of(const Imf::Header& header) {
    const Imath::Box2i& window = header.dataWindow();
    const int64_t width = int64_t{window.max.x} - window.min.x + 1;
    const int64_t height = int64_t{window.max.y} - window.min.y + 1;
    if (width > largest_edge || height > 6 * largest_edge)
        return Error{ErrorKind::unusable_input,
                     cat("it is ", width, "x", height, " texels; usable are up to ", largest_edge,
                         " along an edge")};
    return Size{static_cast<int>(width), static_cast<int>(height)};
}

Result<PixelFormat> format_of(const Imf::Header& header, const std::vector<std::string>& channels,
                              int of_a_texel) {
    bool all_half = true;
    for (const std::string& name : channels) {
        const Imf::Channel* channel = header.channels().findChannel(name);
        if (channel == nullptr || channel->type == Imf::UINT || channel->xSampling != 1 ||
            channel->ySampling != 1)
            return Error{ErrorKind::unusable_input,
                         cat("its channel ", name, " is missing, subsampled or of whole numbers; ",
                             "needed are ", join(channels, ", "), " of half floats or floats")};
        all_half = all_half && channel->type == Imf::HALF;
    }
    if (of_a_texel == 2) return all_half ? PixelFormat::rg16f : PixelFormat::rg32f;
    return all_half ? PixelFormat::rgba16f : PixelFormat::rgba32f;
}

std::map<std::string, std::string> metadata_of(const Imf::Header& header) {
    std::map<std::string, std::string> metadata;
    for (auto it = header.begin(); it != header.end(); ++it) {
        const std::string key = it.name();
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute());
        if (text != nullptr && key != "type" && key != "name") metadata[key] = text->value();
    }
    return metadata;
}

Imf::FrameBuffer frame_buffer_over(std::span<std::byte> texels, PixelFormat format,
                                   const std::vector<std::string>& channels,
                                   const Imath::Box2i& window) {
    const auto stride = static_cast<size_t>(info_of(format).bytes_per_texel);
    const size_t row = stride * static_cast<size_t>(window.max.x - window.min.x + 1);
    Imf::FrameBuffer buffer;
    size_t offset = 0;
    for (const std::string& name : channels) {
        buffer.insert(
            name, Imf::Slice::Make(type_of(format), texels.data() + offset, window, stride, row));
        offset += bytes_of_channel(format);
    }
    return buffer;
}

std::vector<std::byte> blank_texels(PixelFormat format, size_t count) {
    const auto stride = static_cast<size_t>(info_of(format).bytes_per_texel);
    std::vector<std::byte> texels(count * stride);
    if (!holds_alpha(format)) return texels;
    const std::vector<float> black(count * 3);
    encode_texels(format, 3, black, texels);
    return texels;
}

}  // namespace splitsum::exr
