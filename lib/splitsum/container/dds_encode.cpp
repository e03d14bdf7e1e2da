#include <algorithm>
#include <cstring>

#include "splitsum/container/dds.h"
#include "splitsum/container/dds_layout_detail.h"
#include "splitsum/container/encode_detail.h"

namespace splitsum {
namespace {

using Bytes = std::vector<std::byte>;

const dds::FormatCode& code_of(PixelFormat format) {
    return *std::ranges::find(dds::format_codes, format, &dds::FormatCode::format);
}

bool needs_dx10(const TextureAsset& texture) {
    return texture.layer_count > 1 || code_of(texture.format).d3dfmt == 0;
}

dds::Header header_of(const TextureAsset& texture) {
    const bool cube = texture.face_count == face_count;
    dds::Header header;
    header.flags = dds::flag_caps | dds::flag_height | dds::flag_width | dds::flag_pitch |
                   dds::flag_pixel_format;
    header.caps = dds::caps_texture;
    header.width = static_cast<uint32_t>(texture.width);
    header.height = static_cast<uint32_t>(texture.height);
    header.pitch = static_cast<uint32_t>(texture.width * info_of(texture.format).bytes_per_texel);
    header.level_count = static_cast<uint32_t>(texture.levels.size());
    header.pixel_format.flags = dds::pixel_format_four_cc;
    header.pixel_format.four_cc =
        needs_dx10(texture) ? dds::four_cc_dx10 : code_of(texture.format).d3dfmt;
    if (texture.levels.size() > 1) {
        header.flags |= dds::flag_level_count;
        header.caps |= dds::caps_complex | dds::caps_levels;
    }
    if (cube) {
        header.caps |= dds::caps_complex;
        header.caps2 = dds::caps2_cube | dds::caps2_all_faces;
    }
    return header;
}

dds::Dx10Header dx10_header_of(const TextureAsset& texture) {
    return {.dxgi_format = code_of(texture.format).dxgi,
            .dimension = dds::dimension_2d,
            .misc_flags = texture.face_count == face_count ? dds::misc_cube : 0,
            .array_size = static_cast<uint32_t>(texture.layer_count)};
}

}  // namespace

Result<std::vector<std::byte>> encode_dds(const TextureAsset& texture) {
    if (Status valid = validate(texture); !valid) return valid.error();
    Bytes file;
    const dds::Header header = header_of(texture);
    append(file, &header, sizeof header);
    if (needs_dx10(texture)) {
        const dds::Dx10Header more = dx10_header_of(texture);
        append(file, &more, sizeof more);
    }
    const auto slices = static_cast<size_t>(dds::slice_count(texture));
    for (size_t slice = 0; slice < slices; ++slice)
        for (const Bytes& level : texture.levels) {
            const size_t part = level.size() / slices;
            append(file, level.data() + slice * part, part);
        }
    return file;
}

}  // namespace splitsum
