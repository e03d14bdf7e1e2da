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

/// What a table is, as its file says it.
struct TableFacts {
    TablePlan plan;                                              ///< without an automatic size
    std::string value = "split sum: albedo = F0 * red + green";  ///< what a lookup returns
    std::string view_axis = "n.v";                               ///< what the n·v axis counts in
    bool has_geometry = true;                                    ///< whether plan.geometry matters
    double max_abs = 0;          ///< measured on what is stored, at texels
    double max_abs_between = 0;  ///< and between them, as a linear filter reads it
    double max_abs_in_rim = 0;   ///< and outside of the outermost texel centres, clamped
};

/// Everything a reader needs in order to know what a lookup in a texture returns and how the
/// texture was made: the conventions of lib/README.md, written into the file as text under
/// "splitsum.*" keys and read back by splitsum-compare.
struct AssetFacts {
    enum class Kind { specular, irradiance, table };
    Kind kind = Kind::specular;
    SourceFacts source;                        ///< of cubemaps
    Orientation orientation;                   ///< of cubemaps
    FilterPlan filter;                         ///< of cubemaps
    RoughnessCurve curve;                      ///< of specular chains
    std::vector<double> perceptual_roughness;  ///< of every level of a specular chain
    bool stores_irradiance = false;            ///< E rather than E / pi
    TableFacts table;                          ///< of tables
};

/// What the texels of an irradiance cubemap hold, in units of E / pi: pi where that is E, else 1; 1
/// for everything else.
double stored_factor(const AssetFacts& facts);

std::map<std::string, std::string> metadata_of(const AssetFacts& facts);

/// The inverse of metadata_of. Fails with unusable_input where a key that is needed is missing or
/// cannot be read, naming it.
Result<AssetFacts> facts_of(const std::map<std::string, std::string>& metadata);

}  // namespace splitsum
