#pragma once

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/base/text.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum::exr {

/// "R", "G", "B", "A": the first `channels` of them; of the layers of an array "layer0.R" and so on.
std::vector<std::string> channel_names(int channels);
std::vector<std::string> channel_names_of_layer(int channels, int layer);

/// A header for an image of that size with those channels and the metadata of the texture.
/// Fails with bad_argument for a metadata key that OpenEXR uses for itself.
Result<Imf::Header> header_for(const TextureAsset& texture,
                               const std::vector<std::string>& channels, int width, int height);

/// The header at the beginning of a file, before anything of the size it states is allocated.
/// Fails with unreadable_input, or with unusable_input for files of several parts.
Result<Imf::Header> read_header(std::span<const std::byte> file);

/// Pixels of a file's data window.
struct Size {
    int width;
    int height;
};

/// Fails with unusable_input when an image is so large that nothing can be meant by it.
Result<Size> size_of(const Imf::Header& header);

/// The format that holds those channels of a file without loss, a texel having 2 of them or more.
/// Fails with unusable_input when a channel is missing, subsampled or of whole numbers.
Result<PixelFormat> format_of(const Imf::Header& header, const std::vector<std::string>& channels,
                              int of_a_texel);

/// The text attributes of a file.
std::map<std::string, std::string> metadata_of(const Imf::Header& header);

/// `texels`, the pixels of `window` row by row in that format, as OpenEXR reads and writes their
/// first channels under those names. Others are left alone.
Imf::FrameBuffer frame_buffer_over(std::span<std::byte> texels, PixelFormat format,
                                   const std::vector<std::string>& channels,
                                   const Imath::Box2i& window);

/// `count` texels with all bytes 0 but for alpha, which is 1.
std::vector<std::byte> blank_texels(PixelFormat format, size_t count);

/// Runs `body`, which calls OpenEXR, and turns what it throws into an Error of that kind.
template <class Body>
auto guarded(ErrorKind kind, const Body& body) -> decltype(body()) {
    try {
        return body();
    } catch (const std::exception& exception) {
        return Error{kind, cat("OpenEXR: ", exception.what())};
    }
}

}  // namespace splitsum::exr
