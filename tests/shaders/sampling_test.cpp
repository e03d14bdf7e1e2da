// The software driver's samplers and the lookups of the library read the same stored texels.
#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "shaders/noise.h"
#include "shaders/twins.h"
#include "splitsum/sphere/cubemap_lookup.h"
#include "splitsum/table/bilinear.h"
#include "splitsum/verify/reconstruction.h"

namespace splitsum::tests {
namespace {

// Measured: 2.5e-6, as the driver blends in fp32; hardware blends in steps of 1/256.
constexpr double blended = 1e-5;

// Every third direction meets an edge of the cube, some of them near a corner.
Vec3 direction(uint32_t i) {
    const Vec3 d = random_direction(i);
    if (i % 3 != 0) return d;
    return Vec3(d.x < 0 ? -1 : 1, d.y < 0 ? -1 : 1, 2 * d.z) +
           0.05F * Vec3(random_direction(40'000 + i));
}

const std::vector<Float4> directions =
    items(8000, [](uint32_t i) { return float4(direction(i), between(0, 1, 90'000 + i)); });

const std::vector<Float4> coordinates = items(8000, [](uint32_t i) {
    return Float4{unit_float(3 * i), unit_float(3 * i + 1), 0, 0};
});

TEST(SamplingGlsl, ReadsLevelsOfCubemaps) {
    const auto levels = noisy_levels();
    expect_twin({.includes = {"levels", "sampling"},
                 .body = "float level = splitsum_level_linear(asked(0).w, 6.0);\n"
                         "answer.xyz = splitsum_specular_light(levels, asked(0).xyz, level);",
                 .inputs = {directions},
                 .declarations = "uniform SPLITSUM_CUBE levels;",
                 .set_up = [&](Program& program) { program.set_cubemap("levels", levels); }},
                blended, [&](size_t i) {
                    return answer_of(Vec3d(trilinear_lookup(levels, {}, vec3d(directions[i]),
                                                            double(directions[i][3]))));
                });
}

TEST(SamplingGlsl, ReadsIrradiance) {
    const Cubemap irradiance = noisy_cubemap(32, 5);
    expect_twin({.includes = {"sampling"},
                 .body = "answer.xyz = splitsum_irradiance_over_pi(irradiance, asked(0).xyz);",
                 .inputs = {directions},
                 .declarations = "uniform SPLITSUM_CUBE irradiance;",
                 .set_up =
                     [&](Program& program) {
                         program.set_cubemap("irradiance", {&irradiance, 1});
                     }},
                blended, [&](size_t i) {
                    return answer_of(Vec3d(bilinear_lookup(irradiance, vec3d(directions[i]))));
                });
}

TEST(SamplingGlsl, ReadsTablesOfOneLayer) {
    const Table table = noisy_table(48, 2, 1);
    expect_twin({.includes = {"sampling"},
                 .body = "answer.xy = splitsum_read_table(table, asked(0).xy).rg;",
                 .inputs = {coordinates},
                 .declarations = "uniform SPLITSUM_TABLE table;",
                 .set_up = [&](Program& program) { program.set_table("table", table); }},
                blended, [&](size_t i) {
                    Answer read{};
                    read_bilinear(table, {double(coordinates[i][0]), double(coordinates[i][1])},
                                  std::span(read).first(2));
                    return read;
                });
}

TEST(SamplingGlsl, ReadsBothLayersOfAreaLights) {
    const Table table = noisy_table(17, 4, 2);
    for (const size_t layer : {size_t(0), size_t(1)})
        expect_twin(
            {.includes = {"sampling"},
             .body = layer == 0 ? "answer = splitsum_read_ltc(tables, asked(0).xy, 0.0);"
                                : "answer = splitsum_read_ltc(tables, asked(0).xy, 1.0);",
             .inputs = {coordinates},
             .declarations = "uniform SPLITSUM_TABLE_ARRAY tables;",
             .set_up = [&](Program& program) { program.set_table("tables", table); }},
            blended, [&](size_t i) {
                std::array<double, 8> both{};
                read_bilinear(table, {double(coordinates[i][0]), double(coordinates[i][1])}, both);
                Answer read{};
                std::copy_n(both.begin() + 4 * layer, 4, read.begin());
                return read;
            });
}

}  // namespace
}  // namespace splitsum::tests
