#include "picture_file.h"

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/text.h"
#include "splitsum/base/version.h"
#include "splitsum/container/exr_layers.h"
#include "splitsum/png/write_png.h"
#include "splitsum/preview/difference.h"

namespace splitsum::tools {
namespace {

Status write_layers(const Pictures& pictures, const std::filesystem::path& path) {
    std::vector<ExrLayer> layers = {{pictures.truth ? "baked" : "", &pictures.baked}};
    if (pictures.truth) {
        layers.push_back({"truth", &pictures.truth_image});
        layers.push_back({"standard_error", &pictures.standard_error});
    }
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

Status write_pictures(const Pictures& pictures, const Shown& how,
                      const std::filesystem::path& path) {
    if (path.extension() == ".exr") return write_layers(pictures, path);
    int height = pictures.baked.height;
    auto bytes = shown(pictures.baked, how.view, how.exposure_stops);
    if (pictures.truth) {
        const auto truth = shown(pictures.truth_image, how.view, how.exposure_stops);
        const auto difference = difference_picture(pictures.baked, *pictures.truth);
        bytes.insert(bytes.end(), truth.begin(), truth.end());
        bytes.insert(bytes.end(), difference.begin(), difference.end());
        height *= 3;
    }
    return write_png(path, pictures.baked.width, height, bytes);
}

std::vector<std::string> picture_names(const Pictures& pictures,
                                       const std::filesystem::path& path) {
    if (!pictures.truth) return {"baked"};
    return {"baked", "truth", path.extension() == ".exr" ? "standard_error" : "difference"};
}

}  // namespace splitsum::tools
