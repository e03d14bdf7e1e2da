#include <zstd.h>

#include <memory>

#include "splitsum/base/text.h"
#include "splitsum/container/zstd_detail.h"

namespace splitsum {
namespace {

struct FreeContext {
    void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
};

// The format spends at least 3 bytes on a block of at most 128 KiB.
bool can_hold(size_t compressed_size, size_t size) {
    return size / ZSTD_BLOCKSIZE_MAX <= compressed_size / 3;
}

}  // namespace

Result<std::vector<std::byte>> zstd_compress(std::span<const std::byte> content, int level) {
    const std::unique_ptr<ZSTD_CCtx, FreeContext> context(ZSTD_createCCtx());
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
    std::vector<std::byte> frame(ZSTD_compressBound(content.size()));
    const size_t length =
        ZSTD_compress2(context.get(), frame.data(), frame.size(), content.data(), content.size());
    if (ZSTD_isError(length))
        return Error{ErrorKind::internal, cat("Zstandard: ", ZSTD_getErrorName(length))};
    frame.resize(length);
    return frame;
}

Result<std::vector<std::byte>> zstd_decompress(std::span<const std::byte> frames, size_t size) {
    const auto unreadable = [](const auto&... what) {
        return Error{ErrorKind::unreadable_input, cat("its Zstandard data ", what...)};
    };
    const auto stated = ZSTD_getFrameContentSize(frames.data(), frames.size());
    if (stated == ZSTD_CONTENTSIZE_ERROR) return unreadable("is not a Zstandard frame");
    if (stated != ZSTD_CONTENTSIZE_UNKNOWN && stated > size)
        return unreadable("holds ", stated, " bytes where ", size, " are needed");
    if (!can_hold(frames.size(), size))
        return unreadable("of ", frames.size(), " bytes cannot hold ", size);
    std::vector<std::byte> content(size);
    const size_t length =
        ZSTD_decompress(content.data(), content.size(), frames.data(), frames.size());
    if (ZSTD_isError(length)) return unreadable("is corrupt: ", ZSTD_getErrorName(length));
    if (length != size) return unreadable("holds ", length, " bytes where ", size, " are needed");
    return content;
}

}  // namespace splitsum
