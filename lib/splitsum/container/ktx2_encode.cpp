#include <cstring>
#include <map>
#include <numeric>
#include <string>

#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/base/version.h"
#include "splitsum/container/encode_detail.h"
#include "splitsum/container/ktx2.h"
#include "splitsum/container/ktx2_descriptor_detail.h"
#include "splitsum/container/ktx2_layout_detail.h"
#include "splitsum/container/zstd_detail.h"

namespace splitsum {
namespace {

using Bytes = std::vector<std::byte>;

void pad_to_multiple_of(Bytes& file, size_t alignment) {
    file.resize((file.size() + alignment - 1) / alignment * alignment);
}

Status validate(const Ktx2Options& options) {
    if (options.zstd && (options.zstd_level < 1 || options.zstd_level > 22))
        return Error{ErrorKind::bad_argument,
                     cat("the Zstandard level must be 1 to 22, got ", options.zstd_level)};
    return ok;
}

// The texture's metadata and the keys of the specification. std::map sorts bytes as unsigned, which
// for UTF-8 is the order of code points that the specification asks for.
std::map<std::string, std::string> keys_and_values(const TextureAsset& texture) {
    auto entries = texture.metadata;
    entries[ktx2::orientation_key] = "rd";
    entries[ktx2::writer_key] = cat("splitsum ", version);
    return entries;
}

// Each entry: its length, the key, NUL, the value, NUL, then zeros up to a multiple of four.
Result<Bytes> key_value_data(const TextureAsset& texture) {
    Bytes data;
    for (const auto& [key, value] : keys_and_values(texture)) {
        if (key.empty() || key.find('\0') != std::string::npos)
            return Error{ErrorKind::bad_argument,
                         "a metadata key is empty or holds a NUL, which KTX 2 cannot store"};
        const auto length = static_cast<uint32_t>(key.size() + value.size() + 2);
        append(data, &length, sizeof length);
        append(data, key.c_str(), key.size() + 1);
        append(data, value.c_str(), value.size() + 1);
        pad_to_multiple_of(data, 4);
    }
    return data;
}

Result<std::vector<Bytes>> compressed(const std::vector<Bytes>& levels, int zstd_level) {
    std::vector<Bytes> frames(levels.size());
    std::vector<Status> statuses(levels.size(), ok);
    parallel_rows(static_cast<int>(levels.size()), [&](int row) {
        const auto level = static_cast<size_t>(row);
        auto frame = zstd_compress(levels[level], zstd_level);
        if (frame)
            frames[level] = std::move(*frame);
        else
            statuses[level] = frame.error();
    });
    for (const Status& status : statuses)
        if (!status) return status.error();
    return frames;
}

ktx2::Header header_of(const TextureAsset& texture, const Ktx2Options& options) {
    ktx2::Header header;
    header.vk_format = info_of(texture.format).vk_format;
    header.type_size = ktx2::type_size_of(texture.format);
    header.pixel_width = static_cast<uint32_t>(texture.width);
    header.pixel_height = static_cast<uint32_t>(texture.height);
    header.layer_count = texture.layer_count > 1 ? static_cast<uint32_t>(texture.layer_count) : 0;
    header.face_count = static_cast<uint32_t>(texture.face_count);
    header.level_count = static_cast<uint32_t>(texture.levels.size());
    header.supercompression =
        options.zstd ? ktx2::supercompression_zstd : ktx2::supercompression_none;
    return header;
}

// Appends the levels, smallest first so that a streaming reader sees a picture early, and returns
// their index, largest first. Uncompressed levels are aligned for a GPU to read them in place.
std::vector<ktx2::LevelEntry> append_levels(Bytes& file, const TextureAsset& texture,
                                            const std::vector<Bytes>& stored,
                                            bool supercompressed) {
    const size_t alignment =
        supercompressed
            ? 1
            : std::lcm(static_cast<size_t>(info_of(texture.format).bytes_per_texel), size_t{4});
    std::vector<ktx2::LevelEntry> index(stored.size());
    for (size_t level = stored.size(); level-- > 0;) {
        pad_to_multiple_of(file, alignment);
        index[level] = {file.size(), stored[level].size(), texture.levels[level].size()};
        append(file, stored[level].data(), stored[level].size());
    }
    return index;
}

Bytes assembled(const TextureAsset& texture, const Ktx2Options& options, const Bytes& key_values,
                const std::vector<Bytes>& stored) {
    ktx2::Header header = header_of(texture, options);
    const auto descriptor = ktx2::descriptor_of(texture.format, options.zstd);
    const size_t index_size = stored.size() * sizeof(ktx2::LevelEntry);
    header.dfd_offset = static_cast<uint32_t>(sizeof header + index_size);
    header.dfd_length = static_cast<uint32_t>(descriptor.size() * sizeof(uint32_t));
    header.kvd_offset = header.dfd_offset + header.dfd_length;
    header.kvd_length = static_cast<uint32_t>(key_values.size());

    Bytes file(header.dfd_offset);
    append(file, descriptor.data(), header.dfd_length);
    append(file, key_values.data(), key_values.size());
    const auto index = append_levels(file, texture, stored, options.zstd);
    std::memcpy(file.data(), &header, sizeof header);
    std::memcpy(file.data() + sizeof header, index.data(), index_size);
    return file;
}

}  // namespace

Result<std::vector<std::byte>> encode_ktx2(const TextureAsset& texture,
                                           const Ktx2Options& options) {
    if (Status valid = validate(texture); !valid) return valid.error();
    if (Status valid = validate(options); !valid) return valid.error();
    const auto key_values = key_value_data(texture);
    if (!key_values) return key_values.error();
    if (!options.zstd) return assembled(texture, options, *key_values, texture.levels);
    const auto frames = compressed(texture.levels, options.zstd_level);
    if (!frames) return frames.error();
    return assembled(texture, options, *key_values, *frames);
}

}  // namespace splitsum
