#pragma once

#include <filesystem>

#include "splitsum/bake/light.h"
#include "splitsum/chart/chart_plan.h"
#include "splitsum/chart/panel.h"

namespace splitsum {

/// A whole bake: 7 specular levels (fewer of small faces) and diffuse light of 32², with `auto` and
/// with every method that can. Timed: from opening the file to the last level, everything made anew
/// as in a new process; without what a process takes to start, to encode and to write. `light`, the
/// same panorama, must outlive it; the error is over all probes of all levels but the mirror image.
Panel bake_panel(const std::filesystem::path& panorama, const PanoramaOptions& options,
                 const Light& light, const ChartPlan& plan);

}  // namespace splitsum
