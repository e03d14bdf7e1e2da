#include "splitsum/table/ltc_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "splitsum/base/parallel.h"
#include "splitsum/base/random.h"
#include "splitsum/ltc/polygon_light.h"
#include "splitsum/ltc/polygon_reference.h"
#include "splitsum/table/bilinear.h"
#include "splitsum/table/kinds.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

using Polygon = std::vector<Vec3d>;

// What a renderer shades: a light seen by a surface from a view.
struct Scene {
    Polygon light;
    double n_dot_v;
    double perceptual_roughness;
};

// Numbers in [0, 1) of scene `index`, one after the other.
class Numbers {
public:
    explicit Numbers(uint32_t index) : key_(64 * index) {}
    double next() { return static_cast<double>(unit_float(key_++)); }
    Vec3d next_direction(double lowest_z) {
        const double z = lowest_z + (1 - lowest_z) * next();
        const double phi = 2 * std::numbers::pi * next();
        return {std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z};
    }

private:
    uint32_t key_;
};

// A triangle or a rectangle about a point at distance 1, from 0.3 to 2 wide or to twice that high,
// turned anyhow; centres down to 12 degrees below the horizon, so that many lights cross it.
Scene random_scene(uint32_t index) {
    Numbers numbers(index);
    Scene scene{{}, numbers.next(), numbers.next()};
    const Vec3d centre = numbers.next_direction(-0.2);
    const Basis frame = basis_around(numbers.next_direction(-1));
    const double size = 0.15 * std::pow(2 / 0.15, numbers.next());
    if (numbers.next() < 0.5) {
        const double start = numbers.next();
        for (int i = 0; i < 3; ++i) {
            const double turn =
                2 * std::numbers::pi * (start + (i + 0.6 * (numbers.next() - 0.5)) / 3);
            scene.light.push_back(centre + size * (std::cos(turn) * frame.tangent +
                                                   std::sin(turn) * frame.bitangent));
        }
    } else {
        const double other = size * (0.3 + 0.7 * numbers.next());
        for (const auto& [x, y] : {std::pair(1, 1), {-1, 1}, {-1, -1}, {1, -1}})
            scene.light.push_back(centre + x * size * frame.tangent + y * other * frame.bitangent);
    }
    return scene;
}

TablePlan plan_of(const char* kind) {
    TablePlan plan;
    plan.kind = kind;
    plan.size = 64;
    plan.layout = TexelLayout::edge;
    plan.axes = TableAxes::roughness_nv;
    return plan;
}

Table bake(const TablePlan& plan) {
    NoProgress progress;
    const auto kind = kind_of(plan);
    const auto table = kind->bake(plan, grid_of(plan, kind->view_axis), progress);
    EXPECT_TRUE(table) << table.error().message;
    return arranged(*table, plan);
}

double shaded(const Table& table, const TablePlan& plan, const Scene& scene) {
    std::array<double, 8> read{};
    read_bilinear(table,
                  texture_coordinates(plan, table.width, ViewAxis::sqrt_one_minus_cosine,
                                      scene.n_dot_v, scene.perceptual_roughness),
                  read);
    const LtcInverse inverse{.m00 = read[0], .m20 = read[1], .m02 = read[2], .m22 = read[3]};
    return read[4] * ltc_polygon_light(inverse, scene.light);
}

struct Errors {
    double rms;      // of the difference, lights of radiance 1
    double rel_rms;  // over the rms of the shaded values
};

Errors errors_of(const Table& table, const TablePlan& plan, LtcTarget target) {
    constexpr int scenes = 6000;
    struct Sums {
        double difference2 = 0, value2 = 0;
        Sums operator+(const Sums& other) const {
            return {difference2 + other.difference2, value2 + other.value2};
        }
    };
    const Sums sums = ordered_sum(scenes, [&](int i) {
        const Scene scene = random_scene(static_cast<uint32_t>(i));
        const double value = polygon_light_reference(
            TargetLobe(target, scene.n_dot_v, scene.perceptual_roughness), scene.light);
        const double difference = shaded(table, plan, scene) - value;
        return Sums{difference * difference, value * value};
    });
    return {std::sqrt(sums.difference2 / scenes), std::sqrt(sums.difference2 / sums.value2)};
}

// The product asks for 2 % (rms), of the light's radiance. Measured: GGX 0.5 % of the radiance and
// 2.2 % of the shaded value (the tables published with the paper: 1.8 % and 8.7 %; no choice of the
// four entries brings less than about 2 %: at grazing views GGX has no such shape), Disney diffuse
// 0.07 % and 0.3 %.
TEST(LtcTables, ShadePolygonsAsIntegrationDoes) {
    for (const auto& [name, target, rms, rel_rms] :
         {std::tuple("ltc-ggx", LtcTarget::ggx, 0.006, 0.025),
          std::tuple("ltc-disney", LtcTarget::disney_diffuse, 0.002, 0.006)}) {
        const TablePlan plan = plan_of(name);
        const Errors errors = errors_of(bake(plan), plan, target);
        RecordProperty(std::string(name) + " rms", std::to_string(errors.rms));
        RecordProperty(std::string(name) + " rel_rms", std::to_string(errors.rel_rms));
        EXPECT_LT(errors.rms, rms) << name;
        EXPECT_LT(errors.rel_rms, rel_rms) << name;
    }
}

// The test above must be able to fail: read with its axes the other way round, or with the lobe of a
// surface 10 % rougher, the same table misses.
TEST(LtcTables, TheTestNoticesWrongAxesAndAWrongWidth) {
    const TablePlan plan = plan_of("ltc-ggx");
    const Table table = bake(plan);
    TablePlan swapped = plan;
    swapped.axes = TableAxes::nv_roughness;
    EXPECT_GT(errors_of(table, swapped, LtcTarget::ggx).rel_rms, 0.3);

    Table wider = table;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            std::ranges::copy(table.texel(std::min(63, x + 3), y, 0), wider.texel(x, y, 0).begin());
    EXPECT_GT(errors_of(wider, plan, LtcTarget::ggx).rel_rms, 0.035);
}

TEST(LtcTables, HoldTheSplitSumAndTheSphere) {
    const Table table = bake(plan_of("ltc-ggx"));
    // r = 1, n·v = 1 and r = 0, n·v = 0.
    EXPECT_NEAR(table.texel(63, 0, 1)[0], 0.30685F,
                1e-4F);  // 1 - ln 2, height-correlated at alpha 1
    EXPECT_NEAR(table.texel(0, 63, 1)[0], 1, 1e-5F);
    EXPECT_NEAR(table.texel(0, 63, 1)[1], 1, 1e-5F);
    // The whole sky about a centre at 90 degrees, half of it; a point overhead, all of it.
    EXPECT_NEAR(table.texel(0, 63, 1)[3], 0, 1e-6F);
    EXPECT_NEAR(table.texel(63, 63, 1)[3], 1, 1e-6F);
    EXPECT_NEAR(table.texel(32, 63, 1)[3], 0.5F * (1 + 1.0F / 63), 1e-6F);
    EXPECT_NEAR(table.texel(48, 0, 1)[3], 2 * 48 / 63.0F - 1, 1e-5F);
}

// The lobe is the judge of tables, so it has judges of its own: the whole sky is the albedo, and a
// narrow lobe sees all of a light around its mirror direction and none of one beside it.
TEST(PolygonLightReference, KnowsTheWholeSkyAndTheMirror) {
    for (const double n_dot_v : {0.05, 0.4, 0.9})
        for (const double r : {0.1, 0.5, 1.0}) {
            const TargetLobe lobe(LtcTarget::ggx, n_dot_v, r);
            double sky = 0;
            for (const double x : {-1.0, 1.0})
                for (const double y : {-1.0, 1.0})
                    sky += polygon_light_reference(lobe, Polygon{{x, 0, 0}, {0, y, 0}, {0, 0, 1}});
            const SplitSum sum = split_sum_exact(SmithTerm::height_correlated, n_dot_v, r * r);
            EXPECT_NEAR(sky, sum.a + sum.b, 1e-5) << n_dot_v << " " << r;
        }
    const TargetLobe mirror(LtcTarget::ggx, 0.6, 0.01);
    const Polygon around = {
        {-0.85, 0.1, 0.5}, {-0.85, -0.1, 0.5}, {-0.7, -0.1, 0.7}, {-0.7, 0.1, 0.7}};
    const Polygon beside = {
        {-0.85, 0.3, 0.5}, {-0.85, 0.1, 0.5}, {-0.7, 0.1, 0.7}, {-0.7, 0.3, 0.7}};
    EXPECT_NEAR(polygon_light_reference(mirror, around), 1, 1e-3);
    EXPECT_NEAR(polygon_light_reference(mirror, beside), 0, 1e-3);
}

}  // namespace
}  // namespace splitsum
