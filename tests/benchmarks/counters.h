#pragma once

#include <benchmark/benchmark.h>

#include "splitsum/measure/error_figures.h"

namespace splitsum::benchmarks {

/// Puts the error beside the speed: a faster wrong answer must show.
inline void show(benchmark::State& state, const ErrorFigures& figures) {
    state.counters["rel_rms"] = figures.rel_rms;
    state.counters["max_rel"] = figures.max_rel;
    state.counters["bias"] = figures.bias;
}

/// Shows how many of `per_iteration` are done in a second.
inline void show_rate(benchmark::State& state, const char* name, double per_iteration) {
    state.counters[name] =
        benchmark::Counter(per_iteration, benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace splitsum::benchmarks
