#pragma once

#include <string>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/chart/chart_plan.h"
#include "splitsum/chart/panel.h"
#include "splitsum/measure/error_figures.h"

namespace splitsum {

/// A contestant's place in the chart: one row of the table.
struct Measurement {
    std::string method;
    std::string effort_name;  ///< "" where there is nothing to choose
    double effort = 0;
    double milliseconds = 0;  ///< wall clock, the median of the repeats
    int repeats = 0;
    ErrorFigures figures;
    bool on_front = false;  ///< nothing is both faster and nearer to the truth
};

struct MeasuredPanel {
    PanelFacts facts;
    std::vector<Measurement> rows;  ///< in the order of the contestants
};

/// The figure of a panel that is drawn.
double shown_error(const PanelFacts& facts, const ErrorFigures& figures);

/// Computes the reference, then runs and times one contestant after the other, and adds a row for
/// each to `measured` as soon as it is known: when this fails, the rows so far are good. Everything
/// but times and fronts is the same in every run. Reports one step a contestant. Fails with
/// interrupted, or as a contestant does.
Status measure_panel(const Panel& panel, const TimingPlan& timing, MeasuredPanel& measured,
                     Progress& progress);

/// Marks the rows that no other beats: for every row that is as fast or faster has a larger error.
/// Rows without an error (the reference) and those that are not finite take no part.
void mark_front(MeasuredPanel& panel);

}  // namespace splitsum
