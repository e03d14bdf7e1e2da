#include "splitsum/container/dds.h"

#include "splitsum/container/file_detail.h"

namespace splitsum {

Status write_dds(const TextureAsset& texture, const std::filesystem::path& path) {
    return write_encoded(path, encode_dds(texture));
}

Result<TextureAsset> read_dds(const std::filesystem::path& path) {
    return read_encoded(path, decode_dds);
}

}  // namespace splitsum
