#include "splitsum/base/parallel.h"

#include <oneapi/tbb/task_arena.h>

namespace splitsum {

int ThreadLimit::available() { return tbb::this_task_arena::max_concurrency(); }

}  // namespace splitsum
