#include "splitsum/chart/measure_panel.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "splitsum/chart/stop_only.h"

namespace splitsum {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

// Only complete runs are timed: one that was cut short fails.
Status time_repeats(const Contestant& contestant, const TimingPlan& timing, Progress& stop,
                    Measurement& row) {
    std::vector<double> times;
    const Clock::time_point first = Clock::now();
    do {
        const Clock::time_point start = Clock::now();
        const auto values = contestant.make(stop);
        if (!values) return values.error();
        times.push_back(milliseconds_since(start));
    } while (int(times.size()) < timing.most_repeats &&
             milliseconds_since(first) < 1000 * timing.seconds);
    row.milliseconds = median(times);
    row.repeats = int(times.size());
    return ok;
}

Result<Measurement> measure(const Contestant& contestant, const std::vector<float>& exact,
                            int channels, const TimingPlan& timing, Progress& stop) {
    Measurement row{contestant.method, contestant.effort_name, contestant.effort, 0, 0, {}, false};
    const Clock::time_point start = Clock::now();
    const auto values = contestant.make(stop);
    if (!values) return values.error();
    row.milliseconds = milliseconds_since(start);
    row.repeats = 1;
    row.figures = error_figures(*values, exact, channels);
    if (row.milliseconds >= 1000 * timing.long_run) return row;
    const Status timed = time_repeats(contestant, timing, stop, row);
    if (!timed) return timed.error();
    return row;
}

Measurement reference_row(double milliseconds, size_t values, int channels) {
    Measurement row{"reference", "", 0, milliseconds, 1, {}, false};
    row.figures.texels = int64_t(values) / channels;
    return row;
}

}  // namespace

double shown_error(const PanelFacts& facts, const ErrorFigures& figures) {
    return facts.figure == "max_abs" ? figures.max_abs : figures.rel_rms;
}

Status measure_panel(const Panel& panel, const TimingPlan& timing, MeasuredPanel& measured,
                     Progress& progress) {
    StopOnly stop(progress);
    const int channels = panel.facts.channels;
    measured.facts = panel.facts;
    const Clock::time_point start = Clock::now();
    const auto exact = panel.reference(stop);
    if (!exact) return exact.error();
    if (panel.whole_over_probes > 0)
        measured.rows.push_back(reference_row(panel.whole_over_probes * milliseconds_since(start),
                                              exact->size(), channels));
    for (const Contestant& contestant : panel.contestants) {
        if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted"};
        auto row = measure(contestant, *exact, channels, timing, stop);
        if (!row) return row.error();
        measured.rows.push_back(std::move(*row));
        progress.advance(1);
    }
    return ok;
}

void mark_front(MeasuredPanel& panel) {
    std::vector<Measurement*> fastest;
    for (Measurement& row : panel.rows) {
        const double error = shown_error(panel.facts, row.figures);
        row.on_front = false;
        if (error > 0 && std::isfinite(error)) fastest.push_back(&row);
    }
    const auto error_of = [&](const Measurement* row) {
        return shown_error(panel.facts, row->figures);
    };
    std::ranges::sort(fastest, [&](const Measurement* a, const Measurement* b) {
        return std::pair(a->milliseconds, error_of(a)) < std::pair(b->milliseconds, error_of(b));
    });
    double best = std::numeric_limits<double>::infinity();
    for (Measurement* row : fastest) {
        row->on_front = error_of(row) < best;
        best = std::min(best, error_of(row));
    }
}

}  // namespace splitsum
