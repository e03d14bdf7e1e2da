#include "splitsum/cache/copy_detail.h"

#include <unistd.h>

#include <cerrno>

#include "splitsum/base/buffer.h"
#include "splitsum/base/content_hash.h"

namespace splitsum {
namespace {

constexpr size_t piece = size_t(1) << 20;

}  // namespace

std::optional<CopyFailure> copy_bytes(const Descriptor& from, const Descriptor& to) {
    // What this does not copy, for whatever reason, the loop below copies or says why not.
    while (copy_file_range(from.get(), nullptr, to.get(), nullptr, size_t(1) << 30, 0) > 0) {
    }
    Buffer<char> buffer(piece);
    while (true) {
        const ssize_t count = read(from.get(), buffer.data(), piece);
        if (count == 0) return std::nullopt;
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return CopyFailure{true, errno};
        if (!write_all(to, std::string_view(buffer.data(), static_cast<size_t>(count))))
            return CopyFailure{false, errno};
    }
}

std::optional<FileSum> sum_of(const Descriptor& file) {
    ContentHash hash;
    FileSum sum;
    Buffer<std::byte> buffer(piece);
    while (true) {
        const ssize_t count = pread(file.get(), buffer.data(), piece, sum.bytes);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return std::nullopt;
        if (count == 0) break;
        hash.add(std::span(buffer.data(), static_cast<size_t>(count)));
        sum.bytes += count;
    }
    sum.hash = hash.digits();
    return sum;
}

}  // namespace splitsum
