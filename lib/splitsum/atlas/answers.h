#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "splitsum/atlas/atlas.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/filter/filter_cubemap.h"
#include "splitsum/filter/filter_source.h"

namespace splitsum {

/// The lobe of a reflection with that perceptual roughness; 0 is the mirror image.
Lobe reflection(double perceptual_roughness);

/// "r = 0.3", "mirror, r = 0" or "diffuse".
std::string describe(const Lobe& lobe);

/// One method's cubemap for each lobe; nothing where it does not filter lobes of that kind. The
/// mirror image is the same whatever the method, if it filters reflections. Cube and panorama have
/// the same axes. Fails only when cancelled.
using Answers = std::vector<std::optional<FilteredCubemap>>;
Result<Answers> answers_of(const FilterMethod& method, const FilterSource& source,
                           std::span<const Lobe> lobes, const FilterPlan& effort, int face_size,
                           Progress& progress);

/// What a method says to a lobe that it does not filter.
AtlasCell refusal_of(const Lobe& lobe);

/// How many channels of texels are NaN, infinite or negative: none, in light.
int64_t count_no_light(const Cubemap& cubemap);

/// The answer beside the truth, which fails where texels are no light.
AtlasCell judged(const FilteredCubemap& answer, const Cubemap& truth, double accuracy);

}  // namespace splitsum
