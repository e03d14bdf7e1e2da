#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>

#include <numeric>
#include <vector>

namespace splitsum {

/// Calls body(row) for every row in [0, rows), on as many threads as the caller allows. The body
/// must write to its own row only; then the result does not depend on the number of threads.
template <class Body>
void parallel_rows(int rows, const Body& body) {
    tbb::parallel_for(0, rows, [&](int row) { body(row); });
}

/// Sum of term(row) over [0, rows): rows are evaluated in parallel and added in row order, so the
/// rounding, and therefore the result, does not depend on the number of threads.
template <class Term>
auto ordered_sum(int rows, const Term& term) {
    using Value = decltype(term(0));
    std::vector<Value> partial(static_cast<size_t>(rows));
    parallel_rows(rows, [&](int row) { partial[static_cast<size_t>(row)] = term(row); });
    return std::accumulate(partial.begin(), partial.end(), Value{});
}

/// While it lives, parallel loops of this process use at most `threads` threads (0: all cores).
class ThreadLimit {
public:
    explicit ThreadLimit(int threads)
        : control_(tbb::global_control::max_allowed_parallelism,
                   static_cast<size_t>(threads > 0 ? threads : available())) {}

    /// The number of threads that parallel loops would use without a limit.
    static int available();

private:
    tbb::global_control control_;
};

}  // namespace splitsum
