#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace splitsum::ktx2 {

static_assert(std::endian::native == std::endian::little, "KTX 2 is little-endian, as memory is");

/// «KTX 20»\r\n\x1A\n
inline constexpr std::array<uint8_t, 12> identifier = {0xab, 'K',  'T',  'X',  ' ',  '2',
                                                       '0',  0xbb, '\r', '\n', 0x1a, '\n'};

/// The fixed part of a file, as it lies there (specification, 3 "File structure"): the header and
/// the index of the parts behind the level index.
struct Header {
    std::array<uint8_t, 12> identifier = ktx2::identifier;
    uint32_t vk_format = 0;
    uint32_t type_size = 0;  ///< bytes of the unit to swap on big-endian machines
    uint32_t pixel_width = 0;
    uint32_t pixel_height = 0;  ///< 0 for 1D
    uint32_t pixel_depth = 0;   ///< 0 unless 3D
    uint32_t layer_count = 0;   ///< 0 unless an array
    uint32_t face_count = 0;
    uint32_t level_count = 0;  ///< 0: one level, the reader shall make the others
    uint32_t supercompression = 0;
    uint32_t dfd_offset = 0;  ///< data format descriptor
    uint32_t dfd_length = 0;
    uint32_t kvd_offset = 0;  ///< keys and values
    uint32_t kvd_length = 0;
    uint64_t sgd_offset = 0;  ///< supercompression global data: none of ours has any
    uint64_t sgd_length = 0;
};
static_assert(sizeof(Header) == 80);

/// One entry of the level index behind the header.
struct LevelEntry {
    uint64_t offset = 0;
    uint64_t length = 0;
    uint64_t uncompressed_length = 0;
};
static_assert(sizeof(LevelEntry) == 24);

inline constexpr uint32_t supercompression_none = 0;
inline constexpr uint32_t supercompression_zstd = 2;

inline constexpr const char* orientation_key = "KTXorientation";
inline constexpr const char* writer_key = "KTXwriter";
inline constexpr const char* swizzle_key = "KTXswizzle";

}  // namespace splitsum::ktx2
