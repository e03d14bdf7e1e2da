// The whole shader of a sun and a flat light, run, and at every pixel beside the library.
#include <gtest/gtest.h>

#include "shaders/noise.h"
#include "shaders/runtime_picture.h"
#include "shaders/twins.h"
#include "splitsum/shading/area_light.h"
#include "splitsum/shading/direct_light.h"
#include "splitsum/table/bilinear.h"
#include "splitsum/table/kinds.h"
#include "splitsum/table/ltc_lookup.h"

namespace splitsum::tests {
namespace {

// Matrices near to one, so that light falls through all of them.
Table noisy_ltc(int size) {
    Table table = noisy_table(size, 4, 2);
    for (size_t i = 0; i < table.values.size() / 2; ++i)
        table.values[i] = (i % 4 == 0 || i % 4 == 3 ? 0.7F : -0.2F) + 0.5F * table.values[i];
    return table;
}

struct Lights {
    Vec3d towards_sun;
    Vec3d illuminance{3, 2, 1};
    LightCorners corners = {Vec3d(-1, 2, 2), Vec3d(1.5, 2, 2), Vec3d(1.5, 2.5, 0.5),
                            Vec3d(-1, 2.5, 0.5)};
    Vec3d radiance{5, 6, 7};
    bool two_sided;

    std::vector<float> block() const {
        std::vector<float> values;
        const auto add = [&](const Vec3d& v, double w) {
            for (const double value : {v.x, v.y, v.z, w})
                values.push_back(static_cast<float>(value));
        };
        add(towards_sun, sun_radius);
        add(illuminance, 0);
        for (const Vec3d& corner : corners) add(corner, 0);
        add(radiance, two_sided ? 1 : 0);
        return values;
    }
};

Vec3d from_sun(const Fragment& f, const Material& m, const SurfaceResponse& surface,
               const Lights& lights) {
    const Vec3d specular = direct_specular(f.normal, f.view, lights.towards_sun, surface.f0,
                                           alpha2_under_sun(m.r(), sun_radius));
    return lights.illuminance *
           (specular * surface.compensation +
            surface.diffuse_albedo * direct_diffuse(f.normal, lights.towards_sun));
}

Vec3d from_flat_light(const Fragment& f, const Material& m, const SurfaceResponse& surface,
                      const Lights& lights, const Table& ltc) {
    const TablePlan plan = default_plan(*kind_of({.kind = "ltc-ggx"}));
    std::array<double, 8> read{};
    read_bilinear(ltc,
                  texture_coordinates(plan, ltc.width, ViewAxis::sqrt_one_minus_cosine,
                                      dot(f.normal, f.view), m.r()),
                  read);
    LightCorners corners = lights.corners;
    for (Vec3d& corner : corners) corner -= f.position;
    const Mat3d frame = light_frame(f.normal, f.view);
    const Vec3d reflected(ltc_reflectance(read, surface.f0.x), ltc_reflectance(read, surface.f0.y),
                          ltc_reflectance(read, surface.f0.z));
    return lights.radiance *
           (area_light(ltc_inverse(read), frame, corners, lights.two_sided) * reflected *
                surface.compensation +
            area_light({}, frame, corners, lights.two_sided) * surface.diffuse_albedo);
}

// The sun stands near the mirror direction of the picture's middle, where the highlight is steepest.
// Measured: 3.1e-5.
TEST(RuntimeShaders, ShadeByDirectLight) {
    const Table table = noisy_split_sums(), ltc = noisy_ltc(16);
    for (const uint32_t key : picture_keys) {
        const Material m = random_material(key);
        const Fragment middle =
            Mesh(key).at(Mesh::picture_size * (Mesh::picture_size / 2) + Mesh::picture_size / 2);
        const Lights lights{
            .towards_sun = Vec3d(Vec3(normalize(middle.reflection() + Vec3d(0, 0.1, 0)))),
            .two_sided = key % 20 == 0};
        RuntimeShader shader{"direct_light.frag", {}, {}};
        shader.set_up = [&](Program& program) {
            program.set_table("split_sum_table", table);
            program.set_table("ltc_tables", ltc);
            program.set_block(
                "Material", std::array{m.base_color.x, m.base_color.y, m.base_color.z, m.metalness,
                                       m.perceptual_roughness, 16.0F, 0.0F, 0.0F});
            program.set_block("Lights", lights.block());
        };
        shader.twin = [&](const Fragment& f) {
            const SurfaceResponse surface =
                m.response(look_up(table, dot(f.normal, f.view), m.r()));
            return from_sun(f, m, surface, lights) + from_flat_light(f, m, surface, lights, ltc);
        };
        expect_picture(shader, key, 1e-4);
    }
}

}  // namespace
}  // namespace splitsum::tests
