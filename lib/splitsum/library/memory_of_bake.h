#pragma once

#include <cstdint>

#include "splitsum/bake/bake.h"
#include "splitsum/panorama/panorama.h"

namespace splitsum {

/// How many bytes load_light and bake need at their peak, beyond what the process holds anyway: an
/// upper bound, from what they allocate. `size` as panorama_size tells it, `threads` those that the
/// bake's loops may use.
///
/// Light decides how many harmonics a lobe takes; what is assumed here is the worst light, a single lit
/// texel in complete darkness. A file that is read with PanoramaOptions::repair may have to be kept
/// whole, which is in `size.reading_bytes`.
///
/// Measured: 1.0 to 1.4 times what splitsum-bake has resident beyond its start under that light, 1.0
/// to 2.4 times under skies; from 1024 x 512 to 16384 x 8192 texels, 256² with 7 levels and 512² with 9.
int64_t memory_of_bake(const PanoramaSize& size, const BakePlan& plan, int threads);

/// What bakes leave behind for the next: FilterTables, and what libraries and the heap keep. Once for
/// all of a run, beside memory_of_bake of those that run at the same time.
inline constexpr int64_t memory_of_shared_tables = int64_t{32} << 20;

}  // namespace splitsum
