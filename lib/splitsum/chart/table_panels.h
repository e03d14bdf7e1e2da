#pragma once

#include "splitsum/chart/chart_plan.h"
#include "splitsum/chart/panel.h"

namespace splitsum {

/// The split-sum table by every method of split_sum_methods(), judged at texels by split_sum_exact.
/// Timed: computing the table, one thread or all as everywhere.
Panel table_panel(const ChartPlan& plan);

/// Tables of many sizes, read by a linear filter between texels, where a renderer reads: with texels
/// at the middle of their cells and at the edges, and from samples.
Panel table_between_panel(const ChartPlan& plan);

}  // namespace splitsum
