#pragma once

#include <algorithm>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// Adds every row of a panorama in memory to what takes rows (`Taker::add_rows`), in bands between
/// which the caller may cancel and sees how far it has come. Progress: the stage "measuring" of
/// `steps` steps. Fails only when cancelled.
template <class Taker>
Status add_all_rows(Taker& taker, int steps, const Environment& environment, Progress& progress) {
    constexpr int rows_at_once = 32;
    const size_t floats_per_row = 4 * size_t(environment.width());
    progress.begin("measuring", steps);
    int reported = 0;
    for (int y = 0; y < environment.height(); y += rows_at_once) {
        if (progress.cancelled())
            return Error{ErrorKind::interrupted, "interrupted while measuring"};
        const int rows = std::min(rows_at_once, environment.height() - y);
        taker.add_rows(rows, environment.texels().data() + floats_per_row * size_t(y), 4);
        const int done = int(int64_t(steps) * (y + rows) / environment.height());
        progress.advance(done - reported);
        reported = done;
    }
    return ok;
}

}  // namespace splitsum
