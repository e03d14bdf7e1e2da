#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/chart/chart_plan.h"
#include "splitsum/chart/measure_panel.h"
#include "splitsum/chart/storage.h"
#include "splitsum/panorama/panorama.h"

namespace splitsum {

/// What a line of the chart is, in one sentence.
struct MethodNote {
    std::string name;
    std::string sentence;
};

/// Speed against accuracy of every method, as measured.
struct Chart {
    struct Source {
        std::string name;  ///< what panels call it: the file's name without its ending
        std::string file;
        std::string hash;
        int width = 0;
        int height = 0;
    };

    std::vector<Source> sources;
    int threads = 0;       ///< that parallel loops used
    int probes = 0;        ///< texels compared in a panel of levels
    bool quick = false;    ///< smaller ladders, as --quick asks for
    bool complete = true;  ///< false where measuring was interrupted
    std::vector<MeasuredPanel> panels;
    std::vector<StoredChain> storage;
    std::vector<MethodNote> notes;  ///< of all methods that appear, in the order in which they do
};

struct ChartJob {
    std::vector<std::filesystem::path> panoramas;  ///< at least one
    PanoramaOptions reading;
    bool quick = false;
    ChartPlan plan;
};

/// Reads all panoramas, then measures one panel after another. Everything in the result but times,
/// repeats and fronts is the same in every run. Reports a stage for each panel.
///
/// When it is cancelled it returns what was measured until then, with `complete` unset; fails with
/// interrupted if that is nothing, and as read_panorama does.
Result<Chart> measure_chart(const ChartJob& job, Progress& progress);

}  // namespace splitsum
