#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "splitsum/image/image.h"

namespace splitsum {

/// How many pixels no filter may see, and where the first of each kind is. A pixel counts once, for
/// the worst of its channels: NaN before infinite before negative.
struct Census {
    struct Kind {
        int64_t count = 0;
        int first_x = -1;  ///< the topmost, then leftmost
        int first_y = -1;
    };
    Kind nan;
    Kind infinite;
    Kind negative;

    bool clean() const { return nan.count + infinite.count + negative.count == 0; }
};

/// The census of two parts of an image, of which `above` lies above `below`.
Census operator+(const Census& above, const Census& below);

/// Counts what is not a finite radiance >= 0. Minus zero is zero.
Census take_census(const Image& image);

/// True where every value is a finite radiance >= 0, as in an image whose census is clean. Minus
/// zero is zero. Cost: as fast as memory is read.
bool all_are_radiance(std::span<const float> values);

/// "3 NaN (first at x 17, y 4), 12 negative (first at x 0, y 0)", or "clean".
std::string describe(const Census& census);

/// Makes every pixel of a lat-long image a finite radiance >= 0: negative channels become 0; pixels
/// with NaN or Inf become the mean of the good ones among their eight neighbours, and where there
/// are none, holes close ring by ring from their rims inwards. Columns wrap, and the neighbour above
/// the top row is half a turn away in the same row, beyond the pole. Every ring is computed from
/// earlier rings alone, so the order of the pixels has no say. An image without a single good pixel
/// becomes black. Cost: one pass, and linear in the number of bad pixels.
void repair(Image& image);

}  // namespace splitsum
