#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "splitsum/atlas/atlas.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// A panorama, and the lobes and efforts with which methods are to filter it.
struct LightCase {
    std::string id;
    std::string title;
    std::string problem;
    std::string conduct;
    Environment (*sky)(int rows);
    std::vector<double> perceptual_roughness{};  ///< of the reflections
    bool diffuse = true;                         ///< and diffuse light
    std::optional<int> rows{};                   ///< instead of AtlasPlan::sky_rows
    std::optional<int> face_size{};              ///< instead of AtlasPlan::face_size
    std::vector<int> samples{};         ///< instead of AtlasPlan::samples, one after the other
    std::vector<double> accuracies{};   ///< instead of AtlasPlan::accuracy, likewise
    std::optional<Vec3> everywhere{};   ///< the truth in closed form: a constant
    std::optional<double> tolerance{};  ///< of Verdict::meets, instead of the accuracy
};

/// Every case whose input is light. A case joins by one element.
std::vector<LightCase> light_cases(const AtlasPlan& plan);

/// Goes through one case: each method of the plan (a row) for each effort and lobe (a column),
/// judged by the exact integral. Fails only when cancelled.
Result<AtlasEntry> light_entry(const LightCase& light, const AtlasPlan& plan, Progress& progress);

}  // namespace splitsum
