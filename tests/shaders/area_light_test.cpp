#include "splitsum/shading/area_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shaders/twins.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/text.h"
#include "splitsum/table/bilinear.h"
#include "splitsum/table/kinds.h"
#include "splitsum/table/ltc_lookup.h"

namespace splitsum::tests {
namespace {

constexpr size_t count = 6000;

const std::vector<Float4> coordinates = items(count, [](uint32_t i) {
    return Float4{between(-0.1F, 1.1F, 2 * i), between(-0.1F, 1.1F, 2 * i + 1), 0, 0};
});

TEST(AreaLightGlsl, ReadsTablesWhereTheLibraryDoes) {
    const TableKind kind = *kind_of({.kind = "ltc-ggx"});
    const TablePlan plan = default_plan(kind);
    for (const int size : {2, 17, 64})
        expect_twin(
            {.includes = {"area_light"},
             .body =
                 cat("vec2 a = asked(0).xy; float size = float(", size, ");\n",
                     "answer.xy = splitsum_ltc_coordinates(a.x, a.y, size);\n",
                     "answer.zw = splitsum_ltc_sphere_coordinates(2.0 * a.x - 1.0, a.y, size);"),
             .inputs = {coordinates}},
            1e-6, [&](size_t i) {
                const double x = static_cast<double>(coordinates[i][0]);
                const double y = static_cast<double>(coordinates[i][1]);
                const Vec2d at = texture_coordinates(plan, size, kind.view_axis, x, y);
                const Vec2d sphere = ltc_sphere_coordinates(2 * x - 1, y, size);
                return Answer{at.x, at.y, sphere.x, sphere.y};
            });
}

TEST(AreaLightGlsl, CarriesDirectionsAndReflects) {
    const auto numbers = [](uint32_t first) {
        return items(count, [=](uint32_t i) {
            const uint32_t key = first + 4 * i;
            return Float4{between(-1, 1, key), between(-1, 1, key + 1), between(-1, 1, key + 2),
                          between(-1, 1, key + 3)};
        });
    };
    const auto layer0 = numbers(0), layer1 = numbers(100'000), direction = numbers(200'000);
    expect_twin({.includes = {"area_light"},
                 .body = "answer.xyz = splitsum_ltc_inverse(asked(0)) * asked(2).xyz;\n"
                         "answer.w = splitsum_ltc_reflectance(vec3(asked(2).w), asked(1)).y;",
                 .inputs = {layer0, layer1, direction}},
                few_roundings, [&](size_t i) {
                    const std::array<double, 6> read = {double(layer0[i][0]), double(layer0[i][1]),
                                                        double(layer0[i][2]), double(layer0[i][3]),
                                                        double(layer1[i][0]), double(layer1[i][1])};
                    return answer_of(to_cosine_space(ltc_inverse(read), vec3d(direction[i])),
                                     ltc_reflectance(read, double(direction[i][3])));
                });
}

// A surface, a viewer and a light: convex, anywhere about the surface, in every turn and winding, from
// 0.2 to 4 wide at a distance of 1, some of them triangles.
struct Scene {
    Float4 normal;  // w: roughness
    Float4 view;    // w: 1 for a light of two sides
    std::array<Float4, 4> corners;
};

Scene scene(uint32_t i) {
    const Vec3 n = random_direction(i);
    Vec3 v = random_direction(50'000 + i);
    if (dot(n, v) < 0) v = v - 2 * dot(n, v) * n;  // in front
    if (i % 50 == 0) v = n;
    Scene made{float4(n, unit_float(400'000 + i)), float4(v, i % 2 == 0 ? 1.0F : 0.0F), {}};
    const Vec3d centre(random_direction(100'000 + i));
    const Basis frame = basis_around(normalize(Vec3d(random_direction(150'000 + i))));
    const double width = 0.1 * std::pow(20, double(unit_float(500'000 + i)));
    const double aspect = 0.2 + double(unit_float(700'000 + i));
    const bool triangle = i % 5 == 0;
    for (size_t k = 0; k < 4; ++k) {
        const double angle = 1.57 * double(triangle && k == 3 ? 2 : k) + 0.3 * double(i % 7);
        made.corners[k] =
            float4(Vec3(centre + width * (std::cos(angle) * frame.tangent +
                                          aspect * std::sin(angle) * frame.bitangent)));
    }
    return made;
}

struct Scenes {
    std::vector<std::vector<Float4>> inputs = std::vector<std::vector<Float4>>(6);

    Scenes() {
        for (uint32_t i = 0; i < count; ++i) {
            const Scene made = scene(i);
            inputs[0].push_back(made.normal);
            inputs[1].push_back(made.view);
            for (size_t k = 0; k < 4; ++k) inputs[2 + k].push_back(made.corners[k]);
        }
    }
    Vec3d normal(size_t i) const { return vec3d(inputs[0][i]); }
    Vec3d view(size_t i) const { return vec3d(inputs[1][i]); }
    double roughness(size_t i) const { return double(inputs[0][i][3]); }
    bool two_sided(size_t i) const { return inputs[1][i][3] > 0.5F; }
    LightCorners corners(size_t i) const {
        return {vec3d(inputs[2][i]), vec3d(inputs[3][i]), vec3d(inputs[4][i]), vec3d(inputs[5][i])};
    }
};

// Not along the normal, where any frame will do.
TEST(AreaLightGlsl, HasTheFrameOfTheLibrary) {
    const auto normals = items(count, [](uint32_t i) { return float4(random_direction(i)); });
    const auto views =
        items(count, [](uint32_t i) { return float4(random_direction(50'000 + i)); });
    const Vec3d carried(0.3, -0.5, 0.8);
    expect_twin({.includes = {"area_light"},
                 .body = "answer.xyz = splitsum_light_frame(asked(0).xyz, asked(1).xyz) * "
                         "vec3(0.3, -0.5, 0.8);",
                 .inputs = {normals, views}},
                1e-4, [&](size_t i) {
                    return answer_of(light_frame(vec3d(normals[i]), vec3d(views[i])) * carried);
                });
}

Table ltc_table(const TablePlan& plan) {
    NoProgress progress;
    const TableKind kind = *kind_of(plan);
    return arranged(*kind.bake(plan, grid_of(plan, kind.view_axis), progress), plan);
}

// Diffuse and specular light through the real table, with the sampler that reads it. Measured: 8.7e-5.
TEST(AreaLightGlsl, ShadesFlatLights) {
    const Scenes scenes;
    TablePlan plan = default_plan(*kind_of({.kind = "ltc-ggx"}));
    plan.size = 16;
    const Table table = ltc_table(plan);
    const Question question = {
        .includes = {"area_light", "sampling"},
        .body =
            "vec3 normal = asked(0).xyz; vec3 view = asked(1).xyz; float r = asked(0).w;\n"
            "vec3 corners[4];\n"
            "for (int k = 0; k < 4; ++k) corners[k] = asked(2 + k).xyz;\n"
            "vec2 at = splitsum_ltc_coordinates(dot(normal, view), r, 16.0);\n"
            "mat3 inverse_ltc = splitsum_ltc_inverse(splitsum_read_ltc(tables, at, 0.0));\n"
            "mat3 frame = splitsum_light_frame(normal, view);\n"
            "bool two_sided = asked(1).w > 0.5;\n"
            "answer.x = splitsum_area_light(mat3(1.0), frame, corners, two_sided);\n"
            "answer.y = splitsum_area_light(inverse_ltc, frame, corners, two_sided);\n"
            "answer.z = splitsum_ltc_reflectance(vec3(0.3), "
            "splitsum_read_ltc(tables, at, 1.0)).x;",
        .inputs = scenes.inputs,
        .declarations = "uniform SPLITSUM_TABLE_ARRAY tables;",
        .set_up = [&](Program& program) { program.set_table("tables", table); }};
    size_t lit = 0;
    expect_twin(question, 3e-4, [&](size_t i) {
        const Vec3d n = scenes.normal(i), v = scenes.view(i);
        std::array<double, 8> read{};
        read_bilinear(table,
                      texture_coordinates(plan, plan.size, ViewAxis::sqrt_one_minus_cosine,
                                          dot(n, v), scenes.roughness(i)),
                      read);
        const Mat3d frame = light_frame(n, v);
        const LightCorners corners = scenes.corners(i);
        const bool two_sided = scenes.two_sided(i);
        const double specular = area_light(ltc_inverse(read), frame, corners, two_sided);
        lit += specular > 0.01;
        return Answer{area_light({}, frame, corners, two_sided), specular,
                      ltc_reflectance(read, 0.3), 0};
    });
    EXPECT_GT(lit, count / 8);  // both languages together
}

}  // namespace
}  // namespace splitsum::tests
