#include "splitsum/chart/chart_plan.h"

namespace splitsum {

ChartPlan full_chart_plan() { return {}; }

ChartPlan quick_chart_plan() {
    ChartPlan plan;
    plan.level_size = 16;
    plan.bake_size = 128;
    plan.table_size = 64;
    plan.probes = 64;
    plan.samples = {16, 64, 256, 1024};
    plan.bake_samples = {64, 256};
    plan.accuracies = {1e-1, 1e-2, 1e-3, 1e-5};
    plan.table_accuracies = {1e-1, 1e-3, 1e-5, 1e-7};
    plan.table_samples = {16, 128, 1024};
    plan.table_sizes = {16, 64, 256};
    plan.storage_sizes = {32, 64, 128, 256};
    plan.storage_probes = 96;
    plan.timing = {3, 0.1, 0.3};
    return plan;
}

}  // namespace splitsum
