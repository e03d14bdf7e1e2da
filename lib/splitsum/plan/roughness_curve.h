#pragma once

#include <string>
#include <vector>

#include "splitsum/base/result.h"

namespace splitsum {

/// Which perceptual roughness each mip level holds.
///
/// `linear`: r = level / (levels - 1), as Bevy and the glTF samplers read it. `filament`:
/// r = 1 - sqrt(1 - lod) with lod = level / (levels - 1), as Filament and three read it (their
/// lod is r (2 - r)). A list names every level itself. The twin of
/// shaders/include/splitsum_levels.glsl.
struct RoughnessCurve {
    enum class Kind { linear, filament, list };
    Kind kind = Kind::linear;
    std::vector<double> list;  ///< perceptual roughness of every level, never falling, in [0, 1]
};

/// Fails with bad_argument for a list that is empty, falls, or leaves [0, 1].
Status validate(const RoughnessCurve& curve);

/// Reads "linear", "filament" or a list such as "0,0.25,0.5,1". Fails with bad_argument.
Result<RoughnessCurve> parse_roughness_curve(const std::string& text);

/// What Babylon.js reads by default: level 0.8 log2(face_size alpha_read), where alpha_read is the
/// squared perceptual roughness + 0.0005 (Babylon.js 9, pbrHelperFunctions, pbrIBLFunctions; the 0.8
/// is its lodGenerationScale). So level l holds r with r^2 = 2^(l / 0.8) / face_size - 0.0005, at
/// most 1; level 0 is the mirror, as in Babylon's own filter. A list, because the curve depends on
/// the size; 0.8 log2(face_size) + 1 levels, rounded up, reach r = 1.
RoughnessCurve babylon_curve(int face_size, int levels);

/// As parse_roughness_curve, and "babylon" for babylon_curve of that chain.
Result<RoughnessCurve> parse_roughness_curve_of_chain(const std::string& text, int face_size,
                                                      int levels);

/// The text that parse_roughness_curve reads back as the same curve, to the last bit.
std::string to_string(const RoughnessCurve& curve);

/// The perceptual roughness of each of `levels` levels; a single level holds r = 0, unless a list
/// says otherwise. A list must have `levels` values.
std::vector<double> roughness_of_levels(const RoughnessCurve& curve, int levels);

/// The level, between 0 and levels - 1 and in general not whole, at which a renderer finds
/// `perceptual_roughness` (clamped to [0, 1]). Between the values of a list the level is linear in
/// the roughness; outside of them it is the first or the last.
double level_of_roughness(const RoughnessCurve& curve, int levels, double perceptual_roughness);

}  // namespace splitsum
