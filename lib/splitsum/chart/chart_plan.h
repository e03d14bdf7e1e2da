#pragma once

#include <vector>

namespace splitsum {

/// How long one contestant is timed, after a first run that warms it up and gives the values.
struct TimingPlan {
    int most_repeats = 7;
    double seconds = 0.4;  ///< no repeat begins after this; there is always one
    double long_run = 1;   ///< seconds from which the first run counts: it is warm for most of it
};

/// The ladders of effort, and what is made with them. Pure data.
struct ChartPlan {
    std::vector<double> perceptual_roughness = {0.05, 0.125, 0.25, 0.5, 1};
    int level_size = 32;   ///< texels along a face's edge of a specular level and of diffuse light
    int bake_size = 256;   ///< of level 0 of a whole chain
    int table_size = 128;  ///< texels along an edge
    int probes = 256;      ///< texels of a level that are compared with `reference`

    std::vector<int> samples = {16, 64, 256, 1024, 4096, 16384};  ///< fewer for slow methods
    std::vector<int> bake_samples = {64, 256, 1024, 4096};
    std::vector<double> accuracies = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5};
    std::vector<int> harmonics_orders = {2, 3, 4};
    std::vector<int> gaussian_counts = {6, 12, 24};  ///< lobes
    std::vector<double> table_accuracies = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7};
    std::vector<int> table_samples = {16, 64, 256, 1024, 4096};
    std::vector<int> table_sizes = {16, 32, 64, 128, 256, 512};

    std::vector<int> storage_sizes = {32, 64, 128, 256, 512};
    int storage_probes = 512;  ///< in each band of roughness

    TimingPlan timing;
};

/// The default: a 1024 x 512 capture in a few minutes on 2 cores.
ChartPlan full_chart_plan();

/// Smaller ladders, assets and numbers of probes: half a minute.
ChartPlan quick_chart_plan();

}  // namespace splitsum
