#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "splitsum/filter/asset_levels.h"
#include "splitsum/filter/methods.h"

namespace splitsum::tests {

/// The names of all methods that filter reflections.
inline std::vector<std::string> reflection_methods() {
    std::vector<std::string> names;
    for (const FilterMethod& method : filter_methods())
        if (method.filters_ggx) names.emplace_back(method.name);
    return names;
}

/// Cubemaps of `face_size` at each roughness, by the method; 1024 samples.
inline std::vector<Cubemap> levels_by(const std::string& method, const Environment& sky,
                                      const std::vector<double>& perceptual_roughness,
                                      int face_size) {
    std::vector<Cubemap> levels;
    for (const double r : perceptual_roughness) {
        LevelsPlan plan;
        plan.specular = SpecularPlan{.face_size = face_size, .levels = 1, .roughness = {}};
        plan.specular->roughness = {RoughnessCurve::Kind::list, {r}};
        plan.filter.method = method;
        NoProgress progress;
        auto filtered = filter_levels(sky, plan, progress);
        EXPECT_TRUE(filtered) << method << ": " << (filtered ? "" : filtered.error().message);
        levels.push_back(filtered ? std::move(filtered->specular[0]) : Cubemap(face_size));
    }
    return levels;
}

/// Every channel is a number, not infinite and not negative.
inline void expect_light(const Cubemap& level) {
    for (size_t i = 0; i < level.texels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = level.texels[i][c];
            ASSERT_TRUE(std::isfinite(value) && value >= 0) << value << " in texel " << i;
        }
}

/// A suite that runs once for every method.
class EveryReflectionMethod : public testing::TestWithParam<std::string> {};

}  // namespace splitsum::tests
