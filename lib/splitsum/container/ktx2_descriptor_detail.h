#pragma once

#include <cstdint>
#include <vector>

#include "splitsum/texture/pixel_format.h"

namespace splitsum::ktx2 {

/// The data format descriptor of a format, in 32-bit words with the total size first: one basic
/// block (Khronos Data Format Specification 1.3, 5), linear light with BT.709 primaries.
///
/// `supercompressed` descriptors state 0 bytes in plane 0: KTX 2.0 wants the texels of such files
/// marked as "unsized". (A revision under way drops that; readers accept both.)
std::vector<uint32_t> descriptor_of(PixelFormat format, bool supercompressed);

/// KTX 2's typeSize: the bytes of the unit that a big-endian reader has to swap.
uint32_t type_size_of(PixelFormat format);

}  // namespace splitsum::ktx2
