#include "splitsum/container/exr_table.h"

#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>

#include "splitsum/base/text.h"
#include "splitsum/container/exr_header_detail.h"
#include "splitsum/container/exr_memory_detail.h"
#include "splitsum/container/file_detail.h"
#include "splitsum/container/limits_detail.h"

namespace splitsum {
namespace {

Status check_table(const TextureAsset& texture) {
    if (Status valid = validate(texture); !valid) return valid;
    if (texture.face_count != 1 || texture.levels.size() != 1 ||
        info_of(texture.format).channels != 2)
        return Error{ErrorKind::bad_argument,
                     cat("a texture of ", info_of(texture.format).name, " with ",
                         texture.face_count, " faces and ", texture.levels.size(),
                         " levels is no table; EXR tables are one level of rg16f or rg32f")};
    return ok;
}

}  // namespace

Result<std::vector<std::byte>> encode_exr_table(const TextureAsset& texture) {
    if (Status valid = check_table(texture); !valid) return valid.error();
    const auto header = exr::header_for(texture, texture.width, texture.height);
    if (!header) return header.error();
    return exr::guarded(ErrorKind::internal, [&]() -> Result<std::vector<std::byte>> {
        exr::MemoryOutput stream;
        {
            auto texels = texture.levels.front();
            Imf::OutputFile file(stream, *header);
            file.setFrameBuffer(
                exr::frame_buffer_over(texels, texture.format, header->dataWindow()));
            file.writePixels(texture.height);
        }
        return stream.take();
    });
}

Result<TextureAsset> decode_exr_table(std::span<const std::byte> bytes) {
    const auto header = exr::read_header(bytes);
    if (!header) return header.error();
    const auto format = exr::format_of(*header, 2);
    if (!format) return format.error();
    const auto size = exr::size_of(*header);
    if (!size) return size.error();

    TextureAsset texture;
    texture.format = *format;
    texture.width = size->width;
    texture.height = size->height;
    texture.metadata = exr::metadata_of(*header);
    texture.levels.resize(1);
    if (Status small_enough = check_memory(texture); !small_enough) return small_enough.error();
    return exr::guarded(ErrorKind::unreadable_input, [&]() -> Result<TextureAsset> {
        exr::MemoryInput stream(bytes);
        Imf::InputFile file(stream);
        const Imath::Box2i window = header->dataWindow();
        texture.levels[0].resize(bytes_of_level(texture, 0));
        file.setFrameBuffer(exr::frame_buffer_over(texture.levels[0], texture.format, window));
        file.readPixels(window.min.y, window.max.y);
        return std::move(texture);
    });
}

Status write_exr_table(const TextureAsset& texture, const std::filesystem::path& path) {
    return write_encoded(path, encode_exr_table(texture));
}

Result<TextureAsset> read_exr_table(const std::filesystem::path& path) {
    return read_encoded(path, decode_exr_table);
}

}  // namespace splitsum
