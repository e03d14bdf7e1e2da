#pragma once

#include <cstddef>
#include <span>

namespace splitsum {

/// lines[k][i] += weights[k] * values[i] for i < count. SIMD (Highway, dispatched at run time).
void add_to_lines(const float* values, size_t count, std::span<const float> weights,
                  std::span<float* const> lines);

/// The sum of values[i]² over i < count, in fp64.
double sum_of_squares(const float* values, size_t count);

}  // namespace splitsum
