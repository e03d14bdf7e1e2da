#pragma once

#include <cstdint>

namespace splitsum::tools {

/// Makes the process give memory back that it has freed, so that what is resident follows what is in
/// use. Called once, before threads are started.
void return_freed_memory();

/// The memory of the process that is resident now, in bytes; 0 where the system does not tell.
int64_t resident_bytes();

}  // namespace splitsum::tools
