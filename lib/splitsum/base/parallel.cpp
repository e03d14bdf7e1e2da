#include "splitsum/base/parallel.h"

#include <oneapi/tbb/task_arena.h>

#include <algorithm>

namespace splitsum {

int ThreadLimit::available() { return tbb::this_task_arena::max_concurrency(); }

int ThreadLimit::in_force() {
    const auto limit =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    return std::min(available(), static_cast<int>(limit));
}

}  // namespace splitsum
