// The include for diffuse tables, compiled as C++, gives what its twin gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>

#include "splitsum/base/random.h"
#include "splitsum/table/albedo_lookup.h"
#include "splitsum/table/kinds.h"
#include "support/temporary_folder.h"

namespace splitsum::tests {
namespace {

// GLM has GLSL's vectors; the literal is a double to C++.
namespace diffuse_glsl {
using glm::vec3;
float min(float x, double y) { return std::min(x, static_cast<float>(y)); }
#include "../../shaders/include/splitsum_diffuse.glsl"
}  // namespace diffuse_glsl

// Albedos up to 2: grazing views of rough surfaces return more than 1.
TEST(DiffuseGlsl, UsesTheTableAsTheLibraryDoes) {
    int bounded = 0;
    for (uint32_t i = 0; i < 5000; ++i) {
        const glm::vec3 color(unit_float(4 * i), unit_float(4 * i + 1), unit_float(4 * i + 2));
        const float albedo = 2 * unit_float(4 * i + 3);
        const Vec3d expected = diffuse_reflectance(Vec3d(color), static_cast<double>(albedo));
        const Vec3d no_more =
            diffuse_reflectance_bounded(Vec3d(color), static_cast<double>(albedo));
        const Vec3d found(diffuse_glsl::splitsum_diffuse_reflectance(color, albedo));
        const Vec3d found_bounded(
            diffuse_glsl::splitsum_diffuse_reflectance_bounded(color, albedo));
        EXPECT_NEAR(length(found - expected), 0, 1e-6);
        EXPECT_NEAR(length(found_bounded - no_more), 0, 1e-6);
        bounded += length(found - found_bounded) > 1e-3;
    }
    EXPECT_GT(bounded, 2000);
}

// The text of every include.
std::string all_includes() {
    std::string text;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(SPLITSUM_SHADERS) / "include"))
        text += bytes_of(entry.path());
    return text;
}

// A table without a lookup is of no use; `ggx` is the one that "the split-sum table" means, and the
// formula brings its own GLSL.
TEST(TablesGlsl, EveryKindOfTableHasALookup) {
    const std::string text = all_includes();
    for (const TableKind& kind : table_kinds()) {
        const std::string name(kind.name);
        if (name == "ggx" || kind.evaluate) continue;
        EXPECT_NE(text.find("`" + name + "`"), std::string::npos) << name;
    }
    EXPECT_EQ(text.find("`no-such-table`"), std::string::npos);
}

}  // namespace
}  // namespace splitsum::tests
