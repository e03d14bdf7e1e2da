#include "splitsum/png/write_png.h"

#include <png.h>

#include <cassert>
#include <vector>

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/text.h"

namespace splitsum {

Result<std::vector<std::byte>> png_of(int width, int height, std::span<const uint8_t> rgb) {
    assert(rgb.size() == 3 * static_cast<size_t>(width) * static_cast<size_t>(height));
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::vector<std::byte> file(size);
    if (!png_image_write_to_memory(&image, file.data(), &size, 0, rgb.data(), 0, nullptr))
        return Error{ErrorKind::internal, cat("libpng: ", image.message)};
    file.resize(size);
    return file;
}

Status write_png(const std::filesystem::path& path, int width, int height,
                 std::span<const uint8_t> rgb) {
    const auto file = png_of(width, height, rgb);
    if (!file)
        return Error{ErrorKind::unwritable_output,
                     cat("cannot write ", path.string(), ": ", file.error().message)};
    return write_bytes_whole(path, *file);
}

}  // namespace splitsum
