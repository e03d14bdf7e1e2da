#pragma once

namespace splitsum {

/// The version of this library, as in CMakeLists.txt; written into every output.
inline constexpr const char* version = SPLITSUM_VERSION;

/// Raised by every change after which equal panoramas and options give other bytes or other figures
/// (the text that names the version in a file aside): what was baked with another number is baked
/// again. Also by a change of a default that a plan leaves open, such as default_probes.
inline constexpr int algorithm_version = 2;

}  // namespace splitsum
