#pragma once

#include <functional>
#include <string>
#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"

namespace splitsum {

/// What a panel of the chart is about: one asset, made in many ways and judged at the same probes.
struct PanelFacts {
    std::string panorama;             ///< "" for tables, which need none
    std::string asset;                ///< "specular", "diffuse", "bake", "table", "table-between"
    double perceptual_roughness = 0;  ///< of a specular level; 0 elsewhere
    int size = 0;       ///< texels along an edge of what is made; 0 where the contestants differ
    int channels = 3;   ///< numbers at each probe
    std::string title;  ///< a few words
    std::string timed;  ///< what the milliseconds cover, as a sentence
    std::string figure = "rel_rms";  ///< the error that is drawn; tables have "max_abs"
};

/// One way to make the asset, at one effort.
struct Contestant {
    std::string method;       ///< a line of the chart
    std::string effort_name;  ///< what the effort counts: "samples", "accuracy", "order", "size"
    double effort = 0;
    /// Makes the whole asset and returns what it holds at the probes; this is what is timed. The same
    /// values every time. Fails only when cancelled or by a fault of ours.
    std::function<Result<std::vector<float>>(Progress&)> make;
};

/// A panel before it is measured.
struct Panel {
    PanelFacts facts;
    std::vector<Contestant> contestants;
    /// The exact values at the probes, computed once for all contestants.
    std::function<Result<std::vector<float>>(Progress&)> reference;
    /// How many times the work at the probes the whole asset would be, for the time that
    /// `reference` would take for all of it; 0 where it is not a contestant.
    double whole_over_probes = 0;
};

}  // namespace splitsum
