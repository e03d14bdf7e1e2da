#include "picture_file.h"

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/text.h"
#include "splitsum/base/version.h"
#include "splitsum/container/exr_layers.h"
#include "splitsum/png/write_png.h"

namespace splitsum::tools {
namespace {

Status write_layers(const std::vector<NamedPicture>& pictures, const std::filesystem::path& path) {
    std::vector<ExrLayer> layers;
    for (const NamedPicture& picture : pictures)
        layers.push_back({pictures.size() == 1 ? "" : picture.name, &picture.picture});
    return write_exr_layers(layers, {{"software", cat("splitsum-preview ", version)}}, path);
}

}  // namespace

Status check_picture_file(const std::filesystem::path& path) {
    if (path.extension() != ".png" && path.extension() != ".exr")
        return Error{ErrorKind::bad_argument,
                     cat("a picture cannot be written as '", path.extension().string(), "' (",
                         path.string(), "); there are: .png, .exr")};
    return check_writable(path);
}

Status write_pictures(const std::vector<NamedPicture>& pictures, const Shown& how,
                      const std::filesystem::path& path) {
    if (path.extension() == ".exr") return write_layers(pictures, path);
    std::vector<uint8_t> bytes;
    int height = 0;
    for (const NamedPicture& picture : pictures) {
        const auto more = shown(picture.picture, how.view, how.exposure_stops);
        bytes.insert(bytes.end(), more.begin(), more.end());
        height += picture.picture.height;
    }
    return write_png(path, pictures.front().picture.width, height, bytes);
}

}  // namespace splitsum::tools
