#include <fstream>

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/text.h"
#include "splitsum/container/file_detail.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

Error cannot_read(const fs::path& path, const Error& error) {
    return {error.kind, cat("cannot read ", path.string(), ": ", error.message)};
}

Result<std::vector<std::byte>> bytes_of_file(const fs::path& path) {
    const auto unreadable = [](const std::string& reason) {
        return Error{ErrorKind::unreadable_input, reason};
    };
    std::error_code failure;
    const fs::file_status status = fs::status(path, failure);
    if (failure) return unreadable(failure.message());
    if (!fs::is_regular_file(status)) return unreadable("it is not a regular file");
    const auto size = fs::file_size(path, failure);
    std::ifstream file(path, std::ios::binary);
    if (failure || !file) return unreadable("it cannot be opened");
    std::vector<std::byte> bytes(size);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (file.gcount() != static_cast<std::streamsize>(size)) return unreadable("reading failed");
    return bytes;
}

}  // namespace

Status write_encoded(const fs::path& path, const Result<std::vector<std::byte>>& encoded) {
    if (encoded) return write_bytes_whole(path, *encoded);
    return Error{encoded.error().kind,
                 cat("cannot write ", path.string(), ": ", encoded.error().message)};
}

Result<TextureAsset> read_encoded(const fs::path& path,
                                  Result<TextureAsset> (*decode)(std::span<const std::byte>)) {
    const auto bytes = bytes_of_file(path);
    if (!bytes) return cannot_read(path, bytes.error());
    auto texture = decode(*bytes);
    if (!texture) return cannot_read(path, texture.error());
    return texture;
}

}  // namespace splitsum
