#pragma once

#include <vector>

#include "splitsum/brdf/smith.h"
#include "splitsum/image/table.h"
#include "splitsum/math/vec.h"

namespace splitsum::benchmarks {

/// The table as published with the split sum (Karis 2013): half vectors drawn from D, a plain loop
/// over texels and Hammersley points in single precision, without SIMD and threads. Points and the
/// cosines of their azimuths are made once for the whole table.
Table scalar_split_sum_table(SmithTerm term, int size, int samples);

}  // namespace splitsum::benchmarks
