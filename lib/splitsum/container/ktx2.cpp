#include "splitsum/container/ktx2.h"

#include "splitsum/container/file_detail.h"

namespace splitsum {

Status write_ktx2(const TextureAsset& texture, const std::filesystem::path& path,
                  const Ktx2Options& options) {
    return write_encoded(path, encode_ktx2(texture, options));
}

Result<TextureAsset> read_ktx2(const std::filesystem::path& path) {
    return read_encoded(path, decode_ktx2);
}

}  // namespace splitsum
