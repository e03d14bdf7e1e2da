#pragma once

#include <map>
#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/plan/asset_plan.h"
#include "splitsum/sphere/orientation.h"

namespace splitsum {

/// Where the light of an asset came from.
struct SourceFacts {
    std::string name;         ///< the file's name without folders
    std::string hash;         ///< "xxh3-128:" and 32 hexadecimal digits
    std::string color_space;  ///< what the file was taken to be in
    double exposure_stops = 0;
    long repaired_texels = 0;  ///< NaN, infinite or negative texels that were replaced
};

/// Everything a reader needs in order to know what a lookup in a texture returns and how the
/// texture was made: the conventions of lib/README.md, written into the file as text under
/// "splitsum.*" keys and read back by splitsum-compare.
struct AssetFacts {
    enum class Kind { specular, irradiance, split_sum };
    Kind kind = Kind::specular;
    SourceFacts source;                        ///< of cubemaps
    Orientation orientation;                   ///< of cubemaps
    FilterPlan filter;                         ///< of cubemaps
    RoughnessCurve curve;                      ///< of specular chains
    std::vector<double> perceptual_roughness;  ///< of every level of a specular chain
    bool stores_irradiance = false;            ///< E rather than E / pi
    TablePlan table;                           ///< of split-sum tables
};

std::map<std::string, std::string> metadata_of(const AssetFacts& facts);

/// The inverse of metadata_of. Fails with unusable_input where a key that is needed is missing or
/// cannot be read, naming it.
Result<AssetFacts> facts_of(const std::map<std::string, std::string>& metadata);

}  // namespace splitsum
