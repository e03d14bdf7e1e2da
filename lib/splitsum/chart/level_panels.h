#pragma once

#include <string>
#include <vector>

#include "splitsum/chart/chart_plan.h"
#include "splitsum/chart/panel.h"
#include "splitsum/filter/filter_source.h"

namespace splitsum {

/// A light by the name that panels call it.
struct NamedLight {
    std::string name;
    FilterSource source;
};

/// One specular level for each roughness of the plan, by every method that filters reflections.
/// Timed: preparing the method for one lobe, and filtering one level. `light` must outlive them.
std::vector<Panel> specular_panels(const NamedLight& light, const ChartPlan& plan);

/// A cubemap of diffuse light by every method that filters it, and as short series of harmonics
/// and a few spherical Gaussians, evaluated at every texel.
Panel diffuse_panel(const NamedLight& light, const ChartPlan& plan);

}  // namespace splitsum
