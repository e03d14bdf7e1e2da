#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "shaders/twins.h"
#include "splitsum/table/albedo_lookup.h"
#include "splitsum/table/kinds.h"
#include "support/temporary_folder.h"

namespace splitsum::tests {
namespace {

// Albedos up to 2: grazing views of rough surfaces return more than 1.
TEST(DiffuseGlsl, UsesTheTableAsTheLibraryDoes) {
    const auto asked = items(5000, [](uint32_t i) {
        return Float4{unit_float(4 * i), unit_float(4 * i + 1), unit_float(4 * i + 2),
                      2 * unit_float(4 * i + 3)};
    });
    const auto compare = [&](const std::string& function, Vec3d (*twin)(const Vec3d&, double)) {
        expect_twin({.includes = {"diffuse"},
                     .body = "answer.xyz = " + function + "(asked(0).xyz, asked(0).w);",
                     .inputs = {asked}},
                    few_roundings, [&](size_t i) {
                        return answer_of(twin(vec3d(asked[i]), static_cast<double>(asked[i][3])));
                    });
    };
    compare("splitsum_diffuse_reflectance", diffuse_reflectance);
    compare("splitsum_diffuse_reflectance_bounded", diffuse_reflectance_bounded);
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
