#include "splitsum/container/exr.h"

#include <OpenEXR/ImfStandardAttributes.h>

#include "splitsum/container/exr_cube.h"
#include "splitsum/container/exr_header_detail.h"
#include "splitsum/container/exr_table.h"
#include "splitsum/container/file_detail.h"

namespace splitsum {
namespace {

Result<TextureAsset> decode_exr(std::span<const std::byte> bytes) {
    const auto header = exr::read_header(bytes);
    if (!header) return header.error();
    return Imf::hasEnvmap(*header) ? decode_exr_cube(bytes) : decode_exr_table(bytes);
}

}  // namespace

Status write_exr(const TextureAsset& texture, const std::filesystem::path& path) {
    return texture.face_count == 1 ? write_exr_table(texture, path) : write_exr_cube(texture, path);
}

Result<TextureAsset> read_exr(const std::filesystem::path& path) {
    return read_encoded(path, decode_exr);
}

}  // namespace splitsum
