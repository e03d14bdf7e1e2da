#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <atomic>
#include <numeric>
#include <span>
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

/// Runs both to their ends, at the same time where a thread is free.
template <class First, class Second>
void run_both(const First& first, const Second& second) {
    tbb::parallel_invoke(first, second);
}

/// Runs work so that a thread which waits inside it, for the last rows of a loop, does nothing else
/// meanwhile: needed where work holds what other work of the same thread may ask for.
template <class Work>
auto run_alone(const Work& work) {
    return tbb::this_task_arena::isolate(work);
}

/// Makes one item after another and takes them in the same order, the next ones being made while
/// one is taken: this lasts as long as the slower of the two alone. With one thread they alternate.
///
/// `make(item)` returns false when there is no more to make, `take(item)` when no more is wanted,
/// after which it is not called again. Neither is ever called twice at a time; both may run on any
/// thread. The items are used in turn, so their number bounds how far making runs ahead.
template <class Item, class Make, class Take>
void make_and_take(std::span<Item> items, const Make& make, const Take& take) {
    std::atomic<bool> wanted = true;
    size_t made = 0;
    // A loop inside `take` that waits for its last rows must not go off and make an item, or the
    // other way round.
    const auto next = [&](tbb::flow_control& flow) -> Item* {
        Item* const item = &items[made++ % items.size()];
        if (!wanted || !run_alone([&] { return make(*item); })) flow.stop();
        return item;
    };
    const auto use = [&](Item* item) {
        if (wanted && !run_alone([&] { return take(*item); })) wanted = false;
    };
    constexpr auto one_by_one = tbb::filter_mode::serial_in_order;
    tbb::parallel_pipeline(items.size(), tbb::make_filter<void, Item*>(one_by_one, next) &
                                             tbb::make_filter<Item*, void>(one_by_one, use));
}

/// While it lives, parallel loops of this process use at most `threads` threads (0: all cores).
class ThreadLimit {
public:
    explicit ThreadLimit(int threads)
        : control_(tbb::global_control::max_allowed_parallelism,
                   static_cast<size_t>(threads > 0 ? threads : available())) {}

    /// The number of threads that parallel loops would use without a limit.
    static int available();

    /// The number of threads that parallel loops use now, with every limit that is in force.
    static int in_force();

private:
    tbb::global_control control_;
};

}  // namespace splitsum
