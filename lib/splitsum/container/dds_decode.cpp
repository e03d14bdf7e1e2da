#include <algorithm>
#include <cstring>
#include <optional>
#include <string>

#include "splitsum/container/dds.h"
#include "splitsum/container/dds_layout_detail.h"
#include "splitsum/container/decode_detail.h"
#include "splitsum/container/limits_detail.h"

namespace splitsum {
namespace {

// Both headers; the second one where the first says that it follows.
struct Headers {
    dds::Header main;
    std::optional<dds::Dx10Header> dx10;
    size_t bytes = sizeof(dds::Header);
};

template <class Pod>
Result<Pod> load(Bytes file, size_t offset, std::string_view what) {
    Pod pod;
    if (file.size() < offset + sizeof pod)
        return unreadable("it ends after ", file.size(), " bytes, inside its ", what);
    std::memcpy(&pod, file.data() + offset, sizeof pod);
    return pod;
}

Result<Headers> read_headers(Bytes file) {
    const size_t comparable = std::min(file.size(), sizeof dds::magic);
    if (comparable == 0 || std::memcmp(file.data(), &dds::magic, comparable) != 0)
        return unreadable("it does not begin as a DDS file does");
    const auto header = load<dds::Header>(file, 0, "DDS header");
    if (!header) return header.error();
    Headers headers{*header, {}};
    if (header->size != 124 || header->pixel_format.size != 32)
        return unreadable("it states headers of ", header->size, " and ", header->pixel_format.size,
                          " bytes; DDS has 124 and 32");
    const auto& pixel_format = header->pixel_format;
    if ((pixel_format.flags & dds::pixel_format_four_cc) == 0 ||
        pixel_format.four_cc != dds::four_cc_dx10)
        return headers;
    const auto dx10 = load<dds::Dx10Header>(file, sizeof(dds::Header), "DX10 header");
    if (!dx10) return dx10.error();
    headers.dx10 = *dx10;
    headers.bytes += sizeof(dds::Dx10Header);
    return headers;
}

std::string usable_formats() {
    return join(pixel_formats(), ", ", [](const PixelFormatInfo& info) { return info.name; });
}

Result<PixelFormat> format_of(const Headers& headers) {
    const auto& stated = headers.main.pixel_format;
    for (const dds::FormatCode& code : dds::format_codes) {
        if (headers.dx10 ? headers.dx10->dxgi_format == code.dxgi
                         : (stated.flags & dds::pixel_format_four_cc) != 0 && code.d3dfmt != 0 &&
                               stated.four_cc == code.d3dfmt)
            return code.format;
    }
    const std::string found = headers.dx10 ? cat("DXGI_FORMAT ", headers.dx10->dxgi_format)
                              : (stated.flags & dds::pixel_format_four_cc) != 0
                                  ? cat("the FourCC ", stated.four_cc)
                                  : cat("no FourCC but bit masks of ", stated.bit_count, " bits");
    return unusable("its texels have ", found, "; usable are ", usable_formats());
}

bool is_cube(const Headers& headers) {
    return headers.dx10 ? (headers.dx10->misc_flags & dds::misc_cube) != 0
                        : (headers.main.caps2 & dds::caps2_cube) != 0;
}

// The kinds of texture that DDS knows and this library does not.
Status check_kind(const Headers& headers) {
    const bool volume = (headers.main.caps2 & dds::caps2_volume) != 0 ||
                        ((headers.main.flags & dds::flag_depth) != 0 && headers.main.depth > 1);
    if (volume || (headers.dx10 && headers.dx10->dimension != dds::dimension_2d))
        return unusable("it is a 1D or 3D texture; usable are 2D and cubemaps");
    if (is_cube(headers) && headers.dx10 && headers.dx10->array_size > 1)
        return unusable("it is an array of ", headers.dx10->array_size,
                        " cubemaps; usable are single cubemaps and 2D arrays");
    if (is_cube(headers) && !headers.dx10 &&
        (headers.main.caps2 & dds::caps2_all_faces) != dds::caps2_all_faces)
        return unusable("it lacks faces of its cubemap; usable are cubemaps with all six");
    return ok;
}

Status check_shape(const Headers& headers) {
    const auto [width, height, levels] =
        std::array{headers.main.width, headers.main.height, headers.main.level_count};
    if (width == 0 || height == 0)
        return unreadable("it states ", width, "x", height, " texels; both must be at least 1");
    if (std::max(width, height) > largest_edge)
        return unreadable("it states ", width, "x", height, " texels; no GPU takes more than ",
                          largest_edge, " along an edge");
    if (is_cube(headers) && width != height)
        return unreadable("it states cube faces of ", width, "x", height,
                          " texels; they are square");
    if (headers.dx10 && (headers.dx10->array_size == 0 || headers.dx10->array_size > most_layers))
        return unreadable("it states ", headers.dx10->array_size, " layers; usable are 1 to ",
                          most_layers);
    const int most = full_level_count(static_cast<int>(width), static_cast<int>(height));
    if (levels > static_cast<uint32_t>(most))
        return unreadable("it states ", levels, " levels; ", width, "x", height,
                          " texels have at most ", most);
    return ok;
}

// The texture without texels, `levels` as many as there will be.
Result<TextureAsset> described_by(const Headers& headers) {
    if (Status kind = check_kind(headers); !kind) return kind.error();
    if (Status shape = check_shape(headers); !shape) return shape.error();
    const auto format = format_of(headers);
    if (!format) return format.error();
    TextureAsset texture;
    texture.format = *format;
    texture.width = static_cast<int>(headers.main.width);
    texture.height = static_cast<int>(headers.main.height);
    texture.face_count = is_cube(headers) ? face_count : 1;
    texture.layer_count = headers.dx10 ? static_cast<int>(headers.dx10->array_size) : 1;
    // Writers differ in whether they state one level as 0 or 1.
    texture.levels.resize(std::max(1u, headers.main.level_count));
    if (Status small_enough = check_memory(texture); !small_enough) return small_enough.error();
    return texture;
}

// `texels` are as many bytes as the levels take.
void read_levels(Bytes texels, TextureAsset& texture) {
    const int slices = dds::slice_count(texture);
    for (int slice = 0; slice < slices; ++slice)
        for (int level = 0; level < static_cast<int>(texture.levels.size()); ++level) {
            const Bytes part =
                texels.first(bytes_of_level(texture, level) / static_cast<size_t>(slices));
            auto& stored = texture.levels[static_cast<size_t>(level)];
            stored.insert(stored.end(), part.begin(), part.end());
            texels = texels.subspan(part.size());
        }
}

}  // namespace

Result<TextureAsset> decode_dds(Bytes file) {
    const auto headers = read_headers(file);
    if (!headers) return headers.error();
    auto texture = described_by(*headers);
    if (!texture) return texture.error();
    size_t needed = headers->bytes;
    for (int level = 0; level < static_cast<int>(texture->levels.size()); ++level)
        needed += bytes_of_level(*texture, level);
    if (file.size() != needed)
        return unreadable("it has ", file.size(), " bytes; its headers and texels take ", needed);
    read_levels(file.subspan(headers->bytes), *texture);
    return texture;
}

}  // namespace splitsum
