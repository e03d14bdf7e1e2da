#pragma once

#include <cstdint>
#include <string>

#include "splitsum/image/image.h"

namespace splitsum {

/// How many pixels no filter may see, and where the first of each kind is. A pixel counts once, for
/// the worst of its channels: NaN before infinite before negative.
struct Census {
    struct Kind {
        int64_t count = 0;
        int first_x = -1;
        int first_y = -1;
    };
    Kind nan;
    Kind infinite;
    Kind negative;

    bool clean() const { return nan.count + infinite.count + negative.count == 0; }
};

/// Counts what is not a finite radiance >= 0. Minus zero is zero.
Census take_census(const Image& image);

/// "3 NaN (first at x 17, y 4), 12 negative (first at x 0, y 0)", or "clean".
std::string describe(const Census& census);

/// Makes every pixel a finite radiance >= 0: negative channels become 0; pixels with NaN or Inf
/// become the mean of the good pixels around them (columns wrap; rings of neighbours grow until one
/// holds a good pixel). An image without a single good pixel becomes black.
void repair(Image& image);

}  // namespace splitsum
