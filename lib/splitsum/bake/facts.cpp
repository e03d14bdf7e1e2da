#include "splitsum/bake/facts.h"

namespace splitsum {
namespace {

AssetFacts cubemap_facts(AssetFacts::Kind kind, const SourceFacts& source, const FilterPlan& filter,
                         const Orientation& orientation) {
    AssetFacts facts;
    facts.kind = kind;
    facts.source = source;
    facts.filter = filter;
    facts.orientation = orientation;
    return facts;
}

}  // namespace

SourceFacts source_facts(const Panorama& panorama) {
    SourceFacts facts;
    facts.name = panorama.source;
    facts.hash = panorama.source_hash;
    facts.color_space = panorama.color_space;
    facts.exposure_stops = panorama.exposure_stops;
    const Census& found = panorama.found;
    if (panorama.repaired)
        facts.repaired_texels = found.nan.count + found.infinite.count + found.negative.count;
    return facts;
}

AssetFacts specular_facts(const SourceFacts& source, const SpecularPlan& specular,
                          const FilterPlan& filter, const Orientation& orientation) {
    AssetFacts facts = cubemap_facts(AssetFacts::Kind::specular, source, filter, orientation);
    facts.curve = specular.roughness;
    facts.perceptual_roughness = roughness_of_levels(specular.roughness, specular.levels);
    return facts;
}

AssetFacts irradiance_facts(const SourceFacts& source, const IrradiancePlan& irradiance,
                            const FilterPlan& filter, const Orientation& orientation) {
    AssetFacts facts = cubemap_facts(AssetFacts::Kind::irradiance, source, filter, orientation);
    facts.stores_irradiance = irradiance.store_irradiance;
    return facts;
}

}  // namespace splitsum
