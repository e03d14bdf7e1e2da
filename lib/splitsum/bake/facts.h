#pragma once

#include "splitsum/panorama/panorama.h"
#include "splitsum/report/asset_facts.h"

namespace splitsum {

/// Where the light of the panorama's assets comes from.
SourceFacts source_facts(const Panorama& panorama);

/// What files of a specular chain and of irradiance made from that source by that plan say.
AssetFacts specular_facts(const SourceFacts& source, const SpecularPlan& specular,
                          const FilterPlan& filter, const Orientation& orientation);
AssetFacts irradiance_facts(const SourceFacts& source, const IrradiancePlan& irradiance,
                            const FilterPlan& filter, const Orientation& orientation);

}  // namespace splitsum
