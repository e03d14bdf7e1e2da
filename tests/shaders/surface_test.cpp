#include "splitsum/shading/surface.h"

#include <gtest/gtest.h>

#include "shaders/twins.h"

namespace splitsum::tests {
namespace {

std::vector<Float4> random_numbers(uint32_t first_key, float high) {
    return items(5000, [=](uint32_t i) {
        const uint32_t key = first_key + 4 * i;
        return Float4{between(0, high, key), between(0, high, key + 1), between(0, high, key + 2),
                      between(0, 1, key + 3)};
    });
}

// Colour and metalness, what is reflected, and light of both kinds.
const std::vector<Float4> materials = random_numbers(0, 1);
const std::vector<Float4> reflectances = random_numbers(100'000, 1);
const std::vector<Float4> specular = random_numbers(200'000, 30);
const std::vector<Float4> diffuse = random_numbers(300'000, 30);

TEST(SurfaceGlsl, KnowsReflectanceAndAlbedo) {
    const auto metalness = [](size_t i) { return static_cast<double>(materials[i][3]); };
    expect_twin({.includes = {"surface"},
                 .body = "answer.xyz = splitsum_f0(asked(0).xyz, asked(0).w);",
                 .inputs = {materials}},
                few_roundings,
                [&](size_t i) { return answer_of(f0_of(vec3d(materials[i]), metalness(i))); });
    expect_twin({.includes = {"surface"},
                 .body = "answer.xyz = splitsum_diffuse_albedo(asked(0).xyz, asked(0).w, "
                         "asked(1).xyz);",
                 .inputs = {materials, reflectances}},
                few_roundings, [&](size_t i) {
                    return answer_of(diffuse_albedo_of(vec3d(materials[i]), metalness(i),
                                                       vec3d(reflectances[i])));
                });
}

TEST(SurfaceGlsl, AddsBothKindsOfLight) {
    expect_twin(
        {.includes = {"surface"},
         .body = "answer.xyz = splitsum_image_based_light(asked(0).xyz, asked(1).xyz, "
                 "asked(2).xyz, asked(3).xyz);",
         .inputs = {specular, diffuse, reflectances, materials}},
        few_roundings, [](size_t i) {
            return answer_of(image_based_light(vec3d(specular[i]), vec3d(diffuse[i]),
                                               vec3d(reflectances[i]), vec3d(materials[i])));
        });
}

}  // namespace
}  // namespace splitsum::tests
