#include "splitsum/shading/direct_light.h"

#include <gtest/gtest.h>

#include "shaders/twins.h"

namespace splitsum::tests {
namespace {

constexpr size_t count = 8000;

// Normals with roughness, views, lights with an angular radius, F0. Every other light stands near the
// mirror direction, where narrow lobes are.
const std::vector<Float4> normals = items(
    count, [](uint32_t i) { return float4(random_direction(i), between(0, 1, 600'000 + i)); });
const std::vector<Float4> views =
    items(count, [](uint32_t i) { return float4(random_direction(50'000 + i)); });

Float4 light(uint32_t i) {
    const float radius = i % 3 == 0 ? 0 : static_cast<float>(sun_radius);
    if (i % 2 == 0) return float4(random_direction(100'000 + i), radius);
    const Vec3d n = vec3d(normals[i]), v = vec3d(views[i]);
    const double off = 0.1 * static_cast<double>(unit_float(200'000 + i));
    const Vec3d near = 2 * dot(n, v) * n - v + off * Vec3d(random_direction(300'000 + i));
    return float4(Vec3(normalize(near)), radius);
}

const std::vector<Float4> lights = items(count, light);
const std::vector<Float4> reflectances = items(count, [](uint32_t i) {
    return Float4{unit_float(3 * i), unit_float(3 * i + 1), unit_float(3 * i + 2), 0};
});

// Lobes without a disc from 0.02 on: below, a few roundings of a direction are 1e-3 of the peak.
double roughness_of(size_t i) {
    const double r = static_cast<double>(normals[i][3]);
    return lights[i][3] > 0 ? r : std::max(r, 0.02);
}

// Measured: 1.1e-4.
TEST(DirectLightGlsl, ReflectsTheSun) {
    const Question question = {
        .includes = {"direct_light"},
        .body =
            "float r = asked(2).w > 0.0 ? asked(0).w : max(asked(0).w, 0.02);\n"
            "float alpha2 = splitsum_alpha2_under_sun(r, asked(2).w);\n"
            "answer.xyz = splitsum_direct_specular(asked(0).xyz, asked(1).xyz, asked(2).xyz, "
            "asked(3).xyz, alpha2);\n"
            "answer.w = splitsum_direct_diffuse(asked(0).xyz, asked(2).xyz);",
        .inputs = {normals, views, lights, reflectances}};
    expect_twin(question, 3e-4, [](size_t i) {
        const Vec3d n = vec3d(normals[i]), l = vec3d(lights[i]);
        const double alpha2 = alpha2_under_sun(roughness_of(i), static_cast<double>(lights[i][3]));
        return answer_of(direct_specular(n, vec3d(views[i]), l, vec3d(reflectances[i]), alpha2),
                         direct_diffuse(n, l));
    });
}

TEST(DirectLightGlsl, WidensTheLobe) {
    expect_twin({.includes = {"direct_light"},
                 .body = "answer.x = 1e5 * splitsum_alpha2_under_sun(0.1 * asked(0).w, "
                         "splitsum_sun_radius);\n"
                         "answer.y = splitsum_alpha2_under_sun(asked(0).w, 0.3);",
                 .inputs = {normals}},
                few_roundings, [](size_t i) {
                    const double r = static_cast<double>(normals[i][3]);
                    return Answer{1e5 * alpha2_under_sun(0.1 * r, sun_radius),
                                  alpha2_under_sun(r, 0.3), 0, 0};
                });
}

}  // namespace
}  // namespace splitsum::tests
