// The whole shaders that light by an environment, run, and at every pixel beside the library.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "shaders/noise.h"
#include "shaders/runtime_picture.h"
#include "shaders/twins.h"
#include "splitsum/filter/irradiance_harmonics.h"
#include "splitsum/shading/directions.h"
#include "splitsum/sphere/cubemap_lookup.h"
#include "splitsum/table/albedo_lookup.h"
#include "splitsum/table/bilinear.h"
#include "splitsum/table/split_sum_fit.h"
#include "splitsum/verify/reconstruction.h"

namespace splitsum::tests {
namespace {

// What fp32 costs between texels that have nothing to do with each other. Measured: 1.2e-5.
constexpr double limit = 5e-5;

Vec3d cube_from_right_handed(const Vec3d& world) {
    return cube_from_world(WorldAxes::right_handed, world);
}

TEST(RuntimeShaders, ShadeByTheEnvironment) {
    const auto levels = noisy_levels();
    const Cubemap irradiance = noisy_cubemap(32, 5);
    const Table table = noisy_split_sums();
    for (const uint32_t key : picture_keys) {
        const Material m = random_material(key);
        const float turn = between(-3, 3, key + 5);
        const auto cube = [&](const Vec3d& world) {
            return turned_environment(cube_from_right_handed(world), static_cast<double>(turn));
        };
        RuntimeShader shader{"image_based_light.frag", {}, {}};
        shader.set_up = [&](Program& program) {
            program.set_cubemap("specular_levels", levels);
            program.set_cubemap("irradiance", {&irradiance, 1});
            program.set_table("split_sum_table", table);
            program.set_block(
                "Material", std::array{m.base_color.x, m.base_color.y, m.base_color.z, m.metalness,
                                       m.perceptual_roughness, 6.0F, turn, 0.0F});
        };
        shader.twin = [&](const Fragment& f) {
            const SurfaceResponse surface =
                m.response(look_up(table, dot(f.normal, f.view), m.r()));
            return image_based_light(
                Vec3d(trilinear_lookup(levels, {}, cube(f.reflection()), m.r())),
                Vec3d(bilinear_lookup(irradiance, cube(f.normal))), surface.reflectance,
                surface.diffuse_albedo);
        };
        expect_picture(shader, key, limit);
    }
}

// Positive on the whole, and below 0 in places, where the shader clamps.
IrradianceHarmonics lopsided_harmonics() {
    IrradianceHarmonics harmonics;
    for (uint32_t i = 0; i < 9; ++i)
        harmonics.coefficients.emplace_back(between(-1, 1, 3 * i), between(-1, 1, 3 * i + 1),
                                            i == 0 ? 3 : 0.2);
    return harmonics;
}

// Material's block of small_target.frag: a list of seven levels and nine coefficients.
std::vector<float> small_target_block(const Material& m, const RoughnessCurve& curve,
                                      const IrradianceHarmonics& harmonics) {
    std::vector<float> block(8 + 16 + 9 * 4);
    const float first[] = {m.base_color.x, m.base_color.y,         m.base_color.z,
                           m.metalness,    m.perceptual_roughness, std::bit_cast<float>(7)};
    std::ranges::copy(first, block.begin());
    for (size_t i = 0; i < curve.list.size(); ++i) block[8 + i] = static_cast<float>(curve.list[i]);
    for (size_t i = 0; i < 9; ++i)
        for (int channel = 0; channel < 3; ++channel)
            block[24 + 4 * i + static_cast<size_t>(channel)] =
                static_cast<float>(harmonics.coefficients[i][channel]);
    return block;
}

TEST(RuntimeShaders, ShadeWithoutTables) {
    const auto levels = noisy_levels();
    const RoughnessCurve curve = *parse_roughness_curve("0,0.1,0.1,0.3,0.5,0.75,0.875");
    const IrradianceHarmonics harmonics = lopsided_harmonics();
    const SmithTerm term = SmithTerm::height_correlated;
    for (const uint32_t key : picture_keys) {
        const Material m = random_material(key);
        RuntimeShader shader{"small_target.frag", {}, {}};
        shader.set_up = [&](Program& program) {
            program.set_cubemap("specular_levels", levels);
            program.set_block("Material", small_target_block(m, curve, harmonics));
        };
        shader.twin = [&](const Fragment& f) {
            const double n_dot_v = std::clamp(dot(f.normal, f.view), 0.0, 1.0);
            const SurfaceResponse surface =
                m.response(evaluate(shipped_fit(term), term, n_dot_v, m.r()));
            const Vec3d diffuse = evaluate(harmonics, cube_from_right_handed(f.normal));
            const Vec3d towards = cube_from_right_handed(f.reflection());
            return image_based_light(
                Vec3d(trilinear_lookup(levels, curve, towards, m.r())),
                {std::max(diffuse.x, 0.0), std::max(diffuse.y, 0.0), std::max(diffuse.z, 0.0)},
                surface.reflectance, surface.diffuse_albedo);
        };
        expect_picture(shader, key, limit);
    }
}

TEST(RuntimeShaders, ShadeCloth) {
    const auto levels = noisy_levels();
    const Cubemap irradiance = noisy_cubemap(32, 5);
    const Table table = noisy_table(32, 1, 1);
    const RoughnessCurve curve{RoughnessCurve::Kind::filament, {}};
    for (const uint32_t key : picture_keys) {
        const Material m = random_material(key);
        const Vec3 sheen(unit_float(key + 6), unit_float(key + 7), unit_float(key + 8));
        RuntimeShader shader{"cloth.frag", {}, {}};
        shader.set_up = [&](Program& program) {
            program.set_cubemap("specular_levels", levels);
            program.set_cubemap("irradiance", {&irradiance, 1});
            program.set_table("cloth_table", table);
            program.set_block("Material",
                              std::array{m.base_color.x, m.base_color.y, m.base_color.z,
                                         m.perceptual_roughness, sheen.x, sheen.y, sheen.z, 6.0F});
        };
        shader.twin = [&](const Fragment& f) {
            double albedo = 0;
            read_bilinear(
                table, texture_coordinates({}, 32, ViewAxis::cosine, dot(f.normal, f.view), m.r()),
                {&albedo, 1});
            const Vec3d towards = cube_from_right_handed(f.reflection());
            const Vec3d diffuse(bilinear_lookup(irradiance, cube_from_right_handed(f.normal)));
            return Vec3d(trilinear_lookup(levels, curve, towards, m.r())) *
                       cloth_reflectance(Vec3d(sheen), albedo) +
                   diffuse * Vec3d(m.base_color) * below_cloth(Vec3d(sheen), albedo);
        };
        expect_picture(shader, key, limit);
    }
}

}  // namespace
}  // namespace splitsum::tests
