#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "splitsum/image/image.h"
#include "splitsum/preview/truth_picture.h"

namespace splitsum {

/// How a relative difference is shown: white for none, red where baked light is too bright, blue
/// where it is too dark, in even steps of encoded sRGB up to full_difference either way.
std::array<uint8_t, 3> difference_color(double relative);

inline constexpr double full_difference = 0.25;

/// What difference_picture() shows where no sphere is.
inline constexpr std::array<uint8_t, 3> difference_background = {30, 31, 34};

/// 1 % of the spheres' mean luminance: what darker truth counts as when differences are related to it.
double least_luminance(const TruthPicture& truth);

/// A picture of baked light beside the truth, as bytes of RGB: the difference of luminance, relative
/// to the truth's, which counts as least_luminance at least. Dark grey where no sphere is. `baked` is of the same size.
std::vector<uint8_t> difference_picture(const Image& baked, const TruthPicture& truth);

}  // namespace splitsum
