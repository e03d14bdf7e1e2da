#pragma once

#include <memory>
#include <span>

#include "splitsum/filter/methods.h"

namespace splitsum {

/// Within so many texels of a narrow lobe's peak, texels are halved until they are small enough.
inline constexpr double reference_near_texels = 25;

/// The judge: the integral of lobe times environment over every texel in fp64, divided by the
/// lobe's integral in closed form (not by its own weights, so that a constant environment tests
/// it).
///
/// Far from the lobe's peak a texel takes 2 x 2 Gauss points; where the lobe changes over less than
/// 25 texels, texels are halved until they are smaller than half the distance to the lobe's complex
/// poles and take up to 6 x 6; where the horizon cuts a texel each of its rows ends exactly there.
/// Relative error: below 1e-7 for panoramas of 64 rows and more (tested against band factors).
/// Cost: half the texels times four evaluations of the lobe for each direction, about 1 ms for
/// 1024 x 512 texels on one core.
std::unique_ptr<PreparedFilter> prepare_reference(const FilterSource& source,
                                                  std::span<const Lobe> lobes,
                                                  const FilterPlan& plan);

}  // namespace splitsum
