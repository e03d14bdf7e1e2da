#include <algorithm>
#include <cstring>
#include <string>

#include "splitsum/base/parallel.h"
#include "splitsum/container/decode_detail.h"
#include "splitsum/container/ktx2.h"
#include "splitsum/container/ktx2_layout_detail.h"
#include "splitsum/container/limits_detail.h"
#include "splitsum/container/zstd_detail.h"

namespace splitsum {
namespace {

template <class Pod>
Pod load(Bytes bytes, size_t offset) {
    Pod pod;
    std::memcpy(&pod, bytes.data() + offset, sizeof pod);
    return pod;
}

// Written so that no sum can overflow.
bool inside(Bytes file, uint64_t offset, uint64_t length) {
    return offset <= file.size() && length <= file.size() - offset;
}

Result<ktx2::Header> read_header(Bytes file) {
    const size_t comparable = std::min(file.size(), ktx2::identifier.size());
    if (comparable == 0 || std::memcmp(file.data(), ktx2::identifier.data(), comparable) != 0)
        return unreadable("it does not begin as a KTX 2 file does");
    if (file.size() < sizeof(ktx2::Header))
        return unreadable("it ends after ", file.size(), " bytes, inside the KTX 2 header of ",
                          sizeof(ktx2::Header));
    return load<ktx2::Header>(file, 0);
}

std::string usable_formats() {
    return join(pixel_formats(), ", ", [](const PixelFormatInfo& info) { return info.name; });
}

Result<PixelFormat> format_of(const ktx2::Header& header) {
    for (const PixelFormatInfo& info : pixel_formats())
        if (info.vk_format == header.vk_format) return info.format;
    return unusable("its texels have VkFormat ", header.vk_format, "; usable are ",
                    usable_formats());
}

// The kinds of texture that KTX 2 knows and this library does not.
Status check_kind(const ktx2::Header& header) {
    if (header.pixel_height == 0) return unusable("it is a 1D texture; usable are 2D and cubemaps");
    if (header.pixel_depth != 0) return unusable("it is a 3D texture; usable are 2D and cubemaps");
    if (header.layer_count != 0 && header.face_count == 6)
        return unusable("it is an array of ", header.layer_count,
                        " cubemaps; usable are single cubemaps and 2D arrays");
    if (header.supercompression != ktx2::supercompression_none &&
        header.supercompression != ktx2::supercompression_zstd)
        return unusable("its supercompression scheme is ", header.supercompression,
                        "; usable are 0 (none) and 2 (Zstandard)");
    return ok;
}

Status check_shape(const ktx2::Header& header) {
    if (header.pixel_width == 0) return unreadable("it states a width of 0");
    if (header.face_count != 1 && header.face_count != 6)
        return unreadable("it states ", header.face_count, " faces; KTX 2 knows 1 and 6");
    if (header.face_count == 6 && header.pixel_width != header.pixel_height)
        return unreadable("it states cube faces of ", header.pixel_width, "x", header.pixel_height,
                          " texels; they are square");
    if (std::max(header.pixel_width, header.pixel_height) > largest_edge)
        return unreadable("it states ", header.pixel_width, "x", header.pixel_height,
                          " texels; no GPU takes more than ", largest_edge, " along an edge");
    if (header.layer_count > most_layers)
        return unreadable("it states ", header.layer_count, " layers; no GPU takes more than ",
                          most_layers);
    const int most = full_level_count(static_cast<int>(header.pixel_width),
                                      static_cast<int>(header.pixel_height));
    if (header.level_count > static_cast<uint32_t>(most))
        return unreadable("it states ", header.level_count, " levels; ", header.pixel_width, "x",
                          header.pixel_height, " texels have at most ", most);
    return ok;
}

// The texture without texels, `levels` as many as there will be.
Result<TextureAsset> described_by(const ktx2::Header& header) {
    if (Status kind = check_kind(header); !kind) return kind.error();
    if (Status shape = check_shape(header); !shape) return shape.error();
    const auto format = format_of(header);
    if (!format) return format.error();
    TextureAsset texture;
    texture.format = *format;
    texture.width = static_cast<int>(header.pixel_width);
    texture.height = static_cast<int>(header.pixel_height);
    texture.face_count = static_cast<int>(header.face_count);
    texture.layer_count = static_cast<int>(std::max(1u, header.layer_count));
    texture.levels.resize(std::max(1u, header.level_count));
    if (Status small_enough = check_memory(texture); !small_enough) return small_enough.error();
    return texture;
}

Status check_parts(Bytes file, const ktx2::Header& header) {
    if (!inside(file, header.dfd_offset, header.dfd_length))
        return unreadable("its data format descriptor lies beyond its end at ", file.size());
    if (header.dfd_length < 4 || load<uint32_t>(file, header.dfd_offset) != header.dfd_length)
        return unreadable("its data format descriptor is missing or misstates its size");
    if (!inside(file, header.kvd_offset, header.kvd_length))
        return unreadable("its keys and values lie beyond its end at ", file.size());
    return ok;
}

Status check_level(Bytes file, const ktx2::LevelEntry& entry, size_t needed, bool supercompressed,
                   size_t level) {
    if (!inside(file, entry.offset, entry.length))
        return unreadable("level ", level, " is said to be ", entry.length, " bytes at ",
                          entry.offset, ", beyond the end at ", file.size());
    const uint64_t stated = supercompressed ? entry.uncompressed_length : entry.length;
    if (stated != needed)
        return unreadable("level ", level, " is said to hold ", stated, " bytes; its texels take ",
                          needed);
    return ok;
}

// No level may share bytes with another or with the index: a file that does was made to confuse.
Status check_overlap(std::vector<ktx2::LevelEntry> entries) {
    uint64_t end = sizeof(ktx2::Header) + entries.size() * sizeof(ktx2::LevelEntry);
    std::ranges::sort(entries, {}, &ktx2::LevelEntry::offset);
    for (const ktx2::LevelEntry& entry : entries) {
        if (entry.offset < end) return unreadable("the bytes of its levels overlap");
        end = entry.offset + entry.length;
    }
    return ok;
}

Result<std::vector<ktx2::LevelEntry>> read_level_index(Bytes file, const TextureAsset& texture,
                                                       bool supercompressed) {
    std::vector<ktx2::LevelEntry> entries;
    for (size_t level = 0; level < texture.levels.size(); ++level) {
        const size_t offset = sizeof(ktx2::Header) + level * sizeof(ktx2::LevelEntry);
        if (!inside(file, offset, sizeof(ktx2::LevelEntry)))
            return unreadable("it ends after ", file.size(), " bytes, inside its level index");
        entries.push_back(load<ktx2::LevelEntry>(file, offset));
        const size_t needed = bytes_of_level(texture, static_cast<int>(level));
        if (Status valid = check_level(file, entries.back(), needed, supercompressed, level);
            !valid)
            return valid.error();
    }
    if (Status apart = check_overlap(entries); !apart) return apart.error();
    return entries;
}

Result<std::map<std::string, std::string>> read_key_values(Bytes data) {
    std::map<std::string, std::string> entries;
    while (data.size() >= sizeof(uint32_t)) {
        const auto length = load<uint32_t>(data, 0);
        data = data.subspan(sizeof(uint32_t));
        if (length > data.size()) return unreadable("an entry of its keys and values is cut short");
        const std::string_view entry(reinterpret_cast<const char*>(data.data()), length);
        const size_t key_end = entry.find('\0');
        if (key_end == entry.npos || key_end == 0)
            return unreadable("an entry of its keys and values has no key");
        std::string_view value = entry.substr(key_end + 1);
        if (value.ends_with('\0')) value.remove_suffix(1);
        entries.emplace(entry.substr(0, key_end), value);
        data = data.subspan(std::min<size_t>(data.size(), (size_t{length} + 3) / 4 * 4));
    }
    return entries;
}

// Keys that change what the texels mean.
Status check_meaning(const TextureAsset& texture) {
    const auto value_of = [&](const char* key, const char* missing) {
        const auto found = texture.metadata.find(key);
        return found == texture.metadata.end() ? std::string(missing) : found->second;
    };
    const std::string orientation = value_of(ktx2::orientation_key, "rd");
    if (orientation != "rd")
        return unusable("its ", ktx2::orientation_key, " is \"", orientation,
                        "\"; usable is \"rd\", row 0 on top");
    // The alpha of a cubemap says nothing; of a table it is a channel like the others.
    const int stored = info_of(texture.format).channels;
    const auto channels =
        static_cast<size_t>(texture.face_count == face_count ? std::min(3, stored) : stored);
    const std::string swizzle = value_of(ktx2::swizzle_key, "rgba");
    if (swizzle.substr(0, channels) != std::string_view("rgba").substr(0, channels))
        return unusable("its ", ktx2::swizzle_key, " is \"", swizzle,
                        "\"; usable are channels in their own order");
    return ok;
}

// Fills texture.levels, which have their number already.
Status read_levels(Bytes file, const std::vector<ktx2::LevelEntry>& entries, bool supercompressed,
                   TextureAsset& texture) {
    std::vector<Status> statuses(entries.size(), ok);
    parallel_rows(static_cast<int>(entries.size()), [&](int row) {
        const auto level = static_cast<size_t>(row);
        const Bytes stored = file.subspan(entries[level].offset, entries[level].length);
        if (!supercompressed) {
            texture.levels[level].assign(stored.begin(), stored.end());
            return;
        }
        auto content = zstd_decompress(stored, entries[level].uncompressed_length);
        if (content)
            texture.levels[level] = std::move(*content);
        else
            statuses[level] = unreadable("level ", level, ": ", content.error().message);
    });
    for (const Status& status : statuses)
        if (!status) return status;
    return ok;
}

}  // namespace

Result<TextureAsset> decode_ktx2(Bytes file) {
    const auto header = read_header(file);
    if (!header) return header.error();
    auto texture = described_by(*header);
    if (!texture) return texture.error();
    if (Status parts = check_parts(file, *header); !parts) return parts.error();
    const bool supercompressed = header->supercompression == ktx2::supercompression_zstd;
    const auto entries = read_level_index(file, *texture, supercompressed);
    if (!entries) return entries.error();
    auto metadata = read_key_values(file.subspan(header->kvd_offset, header->kvd_length));
    if (!metadata) return metadata.error();
    texture->metadata = std::move(*metadata);
    if (Status meaning = check_meaning(*texture); !meaning) return meaning.error();
    if (Status read = read_levels(file, *entries, supercompressed, *texture); !read)
        return read.error();
    return texture;
}

}  // namespace splitsum
