#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "splitsum/texture/texture_asset.h"

namespace splitsum::dds {

static_assert(std::endian::native == std::endian::little, "DDS is little-endian, as memory is");

constexpr uint32_t four_letters(const char (&text)[5]) {
    uint32_t code = 0;
    for (int i = 3; i >= 0; --i) code = code << 8 | static_cast<unsigned char>(text[i]);
    return code;
}

inline constexpr uint32_t magic = four_letters("DDS ");
inline constexpr uint32_t four_cc_dx10 = four_letters("DX10");

/// DDS_PIXELFORMAT.
struct PixelFormatField {
    uint32_t size = 32;
    uint32_t flags = 0;
    uint32_t four_cc = 0;  ///< letters, or the number of a D3DFMT
    uint32_t bit_count = 0;
    std::array<uint32_t, 4> masks{};
};
static_assert(sizeof(PixelFormatField) == 32);

/// The magic number and DDS_HEADER.
struct Header {
    uint32_t magic = dds::magic;
    uint32_t size = 124;  ///< of what follows the magic number
    uint32_t flags = 0;
    uint32_t height = 0;
    uint32_t width = 0;
    uint32_t pitch = 0;        ///< bytes of a row of level 0
    uint32_t depth = 0;        ///< of a 3D texture
    uint32_t level_count = 0;  ///< 0 and 1: one level
    std::array<uint32_t, 11> reserved{};
    PixelFormatField pixel_format;
    uint32_t caps = 0;
    uint32_t caps2 = 0;
    std::array<uint32_t, 3> unused{};
};
static_assert(sizeof(Header) == 128);

/// DDS_HEADER_DXT10, behind the header where four_cc is "DX10".
struct Dx10Header {
    uint32_t dxgi_format = 0;
    uint32_t dimension = 0;
    uint32_t misc_flags = 0;
    uint32_t array_size = 0;  ///< of a cubemap: how many cubemaps
    uint32_t misc_flags2 = 0;
};
static_assert(sizeof(Dx10Header) == 20);

inline constexpr uint32_t flag_caps = 0x1, flag_height = 0x2, flag_width = 0x4, flag_pitch = 0x8,
                          flag_pixel_format = 0x1000, flag_level_count = 0x20000,
                          flag_depth = 0x800000;
inline constexpr uint32_t pixel_format_four_cc = 0x4;
inline constexpr uint32_t caps_complex = 0x8, caps_texture = 0x1000, caps_levels = 0x400000;
inline constexpr uint32_t caps2_cube = 0x200, caps2_all_faces = 0xfc00, caps2_volume = 0x200000;
inline constexpr uint32_t dimension_2d = 3, misc_cube = 0x4;

/// The numbers under which DDS knows a format.
struct FormatCode {
    PixelFormat format;
    uint32_t dxgi;    ///< DXGI_FORMAT
    uint32_t d3dfmt;  ///< D3DFMT of Direct3D 9, or 0 where it has none
};

/// In the order of PixelFormat.
inline constexpr FormatCode format_codes[] = {
    {PixelFormat::rgba16f, 10, 113}, {PixelFormat::rgba32f, 2, 116}, {PixelFormat::rgb9e5, 67, 0},
    {PixelFormat::b10g11r11, 26, 0}, {PixelFormat::rg16f, 34, 112},  {PixelFormat::rg32f, 16, 115},
    {PixelFormat::rg16unorm, 35, 0},
};

/// How many images lie one behind the other, each with all its levels: faces or layers.
inline int slice_count(const TextureAsset& texture) {
    return texture.face_count * texture.layer_count;
}

}  // namespace splitsum::dds
