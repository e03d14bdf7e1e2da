#include "splitsum/container/exr_cube.h"

#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTiledInputFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include <algorithm>
#include <bit>

#include "splitsum/base/text.h"
#include "splitsum/container/exr_cube_layout_detail.h"
#include "splitsum/container/exr_header_detail.h"
#include "splitsum/container/exr_memory_detail.h"
#include "splitsum/container/file_detail.h"
#include "splitsum/container/limits_detail.h"

namespace splitsum {
namespace {

constexpr const char* levels_key = "splitsum.exr.levels";
constexpr unsigned tile_edge = 64;

Status check_cube(const TextureAsset& texture) {
    if (Status valid = validate(texture); !valid) return valid;
    if (texture.face_count != 6)
        return Error{ErrorKind::bad_argument, "a 2D texture is no cubemap"};
    return check_exr_cube({texture.format, texture.width, static_cast<int>(texture.levels.size())});
}

Result<Imf::Header> cube_header(const TextureAsset& texture) {
    auto header = exr::header_for(texture, exr::channel_names(3), texture.width, 6 * texture.width);
    if (!header) return header;
    if (texture.metadata.contains(levels_key))
        return Error{ErrorKind::bad_argument,
                     cat("the metadata key \"", levels_key, "\" is reserved")};
    Imf::addEnvmap(*header, Imf::ENVMAP_CUBE);
    header->insert(levels_key, Imf::IntAttribute(static_cast<int>(texture.levels.size())));
    header->setTileDescription(Imf::TileDescription(
        tile_edge, tile_edge, texture.levels.size() > 1 ? Imf::MIPMAP_LEVELS : Imf::ONE_LEVEL,
        Imf::ROUND_DOWN));
    return header;
}

// Largest level first, in the order of the tile index: some readers go through the file instead.
void write_levels(Imf::TiledOutputFile& file, std::vector<exr::StackLevel> stack,
                  PixelFormat format) {
    for (int level = 0; level < static_cast<int>(stack.size()); ++level) {
        auto& texels = stack[static_cast<size_t>(level)].texels;
        file.setFrameBuffer(exr::frame_buffer_over(texels, format, exr::channel_names(3),
                                                   file.dataWindowForLevel(level)));
        file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
    }
}

Status check_is_cube(const Imf::Header& header, const exr::Size& size) {
    if (!Imf::hasEnvmap(header) || Imf::envmap(header) != Imf::ENVMAP_CUBE)
        return Error{ErrorKind::unusable_input,
                     "it is not marked as a cube-face environment map (attribute envmap)"};
    if (size.height != 6 * size.width)
        return Error{ErrorKind::unusable_input,
                     cat("it is ", size.width, "x", size.height,
                         " texels; a cube-face environment map is six times as high as wide")};
    return ok;
}

// The levels of a file that hold six whole faces; no more than its writer says are meant.
Result<int> level_count_of(const Imf::Header& header, int face_size) {
    if (!header.hasTileDescription() || header.tileDescription().mode == Imf::ONE_LEVEL) return 1;
    const Imf::TileDescription& tiles = header.tileDescription();
    if (tiles.mode != Imf::MIPMAP_LEVELS || tiles.roundingMode != Imf::ROUND_DOWN)
        return Error{ErrorKind::unusable_input,
                     "its levels are RIP levels or rounded up; usable are MIP levels rounded down"};
    int whole = 1;
    while (face_size >> whole > 0 && (6 * face_size) >> whole == 6 * (face_size >> whole)) ++whole;
    const auto* stated = header.findTypedAttribute<Imf::IntAttribute>(levels_key);
    if (stated == nullptr) return whole;
    if (stated->value() < 1 || stated->value() > whole)
        return Error{ErrorKind::unreadable_input,
                     cat("it states ", stated->value(), " levels; ", face_size,
                         " texels along a face have 1 to ", whole)};
    return stated->value();
}

// The texture without texels, `levels` as many as there will be.
Result<TextureAsset> described_by(const Imf::Header& header) {
    const auto size = exr::size_of(header);
    if (!size) return size.error();
    if (Status cube = check_is_cube(header, *size); !cube) return cube.error();
    const auto format = exr::format_of(header, exr::channel_names(3), 3);
    if (!format) return format.error();
    const auto levels = level_count_of(header, size->width);
    if (!levels) return levels.error();
    TextureAsset texture;
    texture.format = *format;
    texture.width = texture.height = size->width;
    texture.face_count = 6;
    texture.levels.resize(static_cast<size_t>(*levels));
    texture.metadata = exr::metadata_of(header);
    if (Status small_enough = check_memory(texture); !small_enough) return small_enough.error();
    return texture;
}

// `read(frame buffer)` fills the pixels of `window`, which are returned.
template <class Read>
std::vector<std::byte> read_window(PixelFormat format, const Imath::Box2i& window,
                                   const Read& read) {
    const auto width = static_cast<size_t>(window.max.x - window.min.x + 1);
    const auto height = static_cast<size_t>(window.max.y - window.min.y + 1);
    auto texels = exr::blank_texels(format, width * height);
    read(exr::frame_buffer_over(texels, format, exr::channel_names(3), window));
    return texels;
}

// Every level of the file, the ones behind the texture's too: a file that was cut short there is not
// to be trusted either.
std::vector<std::vector<std::byte>> read_tiled(exr::MemoryInput& stream, PixelFormat format) {
    Imf::TiledInputFile file(stream);
    std::vector<std::vector<std::byte>> stack;
    for (int level = 0; level < file.numLevels(); ++level)
        stack.push_back(
            read_window(format, file.dataWindowForLevel(level), [&](const auto& buffer) {
                file.setFrameBuffer(buffer);
                file.readTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
            }));
    return stack;
}

std::vector<std::vector<std::byte>> read_scanlines(exr::MemoryInput& stream, PixelFormat format) {
    Imf::InputFile file(stream);
    const Imath::Box2i window = file.header().dataWindow();
    return {read_window(format, window, [&](const auto& buffer) {
        file.setFrameBuffer(buffer);
        file.readPixels(window.min.y, window.max.y);
    })};
}

}  // namespace

Result<std::vector<std::byte>> encode_exr_cube(const TextureAsset& texture) {
    if (Status valid = check_cube(texture); !valid) return valid.error();
    const auto header = cube_header(texture);
    if (!header) return header.error();
    return exr::guarded(ErrorKind::internal, [&]() -> Result<std::vector<std::byte>> {
        exr::MemoryOutput stream;
        {
            Imf::TiledOutputFile file(stream, *header);
            write_levels(file, exr::stack_levels(texture), texture.format);
        }
        return stream.take();
    });
}

Result<TextureAsset> decode_exr_cube(std::span<const std::byte> bytes) {
    const auto header = exr::read_header(bytes);
    if (!header) return header.error();
    auto texture = described_by(*header);
    if (!texture) return texture.error();
    return exr::guarded(ErrorKind::unreadable_input, [&]() -> Result<TextureAsset> {
        exr::MemoryInput stream(bytes);
        const auto stack = header->hasTileDescription() ? read_tiled(stream, texture->format)
                                                        : read_scanlines(stream, texture->format);
        const auto stride = static_cast<size_t>(info_of(texture->format).bytes_per_texel);
        for (size_t level = 0; level < texture->levels.size(); ++level)
            texture->levels[level] =
                exr::turned_faces(stack[level], std::max(1, texture->width >> level), stride);
        return std::move(texture);
    });
}

Status check_exr_cube(const CubeShape& shape) {
    if (shape.format != PixelFormat::rgba16f && shape.format != PixelFormat::rgba32f)
        return Error{ErrorKind::bad_argument,
                     cat("EXR cubemaps are rgba16f or rgba32f, not ", info_of(shape.format).name)};
    if (shape.levels > 1 && !std::has_single_bit(static_cast<unsigned>(shape.face_size)))
        return Error{ErrorKind::bad_argument,
                     cat("EXR cubemaps with several levels need a power of two as face size, got ",
                         shape.face_size, "; other sizes work with a single level or as .ktx2")};
    return ok;
}

Status write_exr_cube(const TextureAsset& texture, const std::filesystem::path& path) {
    return write_encoded(path, encode_exr_cube(texture));
}

Result<TextureAsset> read_exr_cube(const std::filesystem::path& path) {
    return read_encoded(path, decode_exr_cube);
}

}  // namespace splitsum
