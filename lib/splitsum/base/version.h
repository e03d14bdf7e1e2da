#pragma once

namespace splitsum {

/// The version of this library, as in CMakeLists.txt; written into every output.
inline constexpr const char* version = SPLITSUM_VERSION;

}  // namespace splitsum
