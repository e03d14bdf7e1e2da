#include "splitsum/imageio/png_file.h"

#include <OpenImageIO/imageio.h>

#include <cassert>
#include <exception>

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

Status write_png(const std::filesystem::path& final_path, const std::filesystem::path& temporary,
                 const OIIO::ImageSpec& spec, std::span<const uint8_t> rgb) {
    const auto unwritable = [&](const std::string& reason) {
        return Error{ErrorKind::unwritable_output,
                     cat("cannot write ", final_path.string(), ": ", reason)};
    };
    try {
        // By format: the temporary name does not end in .png.
        const auto file = OIIO::ImageOutput::create("png");
        if (!file) return unwritable(OIIO::geterror());
        if (!file->open(temporary.string(), spec) ||
            !file->write_image(OIIO::TypeUInt8, rgb.data()) || !file->close())
            return unwritable(file->geterror());
    } catch (const std::exception& thrown) {
        return unwritable(thrown.what());
    }
    return ok;
}

}  // namespace

Status write_png_rgb8(const std::filesystem::path& path, int width, int height,
                      std::span<const uint8_t> rgb) {
    assert(rgb.size() == 3 * static_cast<size_t>(width) * static_cast<size_t>(height));
    OIIO::ImageSpec spec(width, height, 3, OIIO::TypeUInt8);
    spec["oiio:ColorSpace"] = "sRGB";
    return write_file_whole(path, [&](const std::filesystem::path& temporary) {
        return write_png(path, temporary, spec, rgb);
    });
}

}  // namespace splitsum
