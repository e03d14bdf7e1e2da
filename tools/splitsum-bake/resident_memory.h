#pragma once

#include <cstdint>

namespace splitsum::tools {

/// Bytes of memory that this process holds now, shared libraries included; 0 where the system does
/// not say (/proc/self/statm).
int64_t resident_memory();

}  // namespace splitsum::tools
