// Rows 4, 9, 10 and 11: a sun of one texel, a million times brighter than the sky.
#include <algorithm>

#include "splitsum/filter/irradiance_harmonics.h"
#include "splitsum/verify/check_levels.h"
#include "stability/levels.h"

namespace splitsum::tests {
namespace {

constexpr int rows = 64;

struct Place {
    const char* name;
    int x, y;
};

constexpr Place places[] = {
    {"pole", 5, 0},        {"other pole", 100, rows - 1},
    {"seam", 0, 30},       {"seam, other side", 127, 33},
    {"face edge", 80, 31}, {"nowhere special", 37, 21},
};

Environment sky_with_sun(const Place& place, float radiance) {
    Environment sky(rows);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < 2 * rows; ++x) sky.set_texel(x, y, Vec3(0.1f, 0.2f, 0.3f));
    sky.set_texel(place.x, place.y, Vec3(radiance, 0.7f * radiance, 0.3f * radiance));
    return sky;
}

class Sun : public EveryReflectionMethod {};
INSTANTIATE_TEST_SUITE_P(Methods, Sun, testing::ValuesIn(reflection_methods()));

// The mean of a level is the panorama's. Texel centres are points, so lobes must be wide against
// them; a sun at the pole of 32² faces is seen by few texels. Measured, worst of all places:
// reference 2e-6 for r = 0.5 and more; the methods that sample 1024 points meet the sun with few of
// them where the lobe is wide.
TEST_P(Sun, KeepsItsEnergy) {
    const std::vector<double> roughness = {0, 0.3, 0.5, 1};
    for (const Place& place : places)
        for (const float radiance : {1e5f, 1e6f}) {
            const Environment sky = sky_with_sun(place, radiance);
            const Vec3d mean = mean_radiance(sky);
            const auto levels = levels_by(GetParam(), sky, roughness, 32);
            for (size_t i = 0; i < levels.size(); ++i) {
                SCOPED_TRACE(testing::Message()
                             << place.name << " " << radiance << " r " << roughness[i]);
                expect_light(levels[i]);
                const double limit = roughness[i] == 0            ? 1e-5
                                     : GetParam() == "importance" ? 0.2
                                     : GetParam() == "filtered"   ? 0.05
                                                                  : 2e-3;
                EXPECT_LT(length(mean_radiance(levels[i]) - mean), limit * length(mean));
            }
        }
}

// What a sun lights is brightest towards it, and half a turn away there is sky alone.
TEST_P(Sun, StaysWhereItIs) {
    for (const Place& place : places) {
        const Environment sky = sky_with_sun(place, 1e6f);
        const Vec3d sun =
            direction_of_lat_long((place.x + 0.5) / (2 * rows), (place.y + 0.5) / rows);
        const Cubemap level = levels_by(GetParam(), sky, {0.3}, 32)[0];
        const FacePoint at = face_point_towards(sun), away = face_point_towards(-sun);
        const auto texel_at = [&](const FacePoint& p) {
            return level.at(p.face, std::min(int(p.s * 32), 31), std::min(int(p.t * 32), 31));
        };
        float brightest = 0;
        for (const Vec3& texel : level.texels) brightest = std::max(brightest, texel.x);
        EXPECT_GT(texel_at(at).x, 0.3f * brightest) << place.name;
        EXPECT_NEAR(texel_at(away).x, 0.1f, 0.1f * 0.1f + 1e-6f * brightest) << place.name;
        EXPECT_NEAR(texel_at(away).z, 0.3f, 0.3f * 0.1f + 1e-6f * brightest) << place.name;
    }
}

// Three bands of a sun go below 0; with a window nothing does, wherever the sun stands.
TEST(SunHarmonics, AreNegativeOnlyWithoutAWindow) {
    for (const Place& place : places) {
        const Environment sky = sky_with_sun(place, 1e6f);
        EXPECT_LT(irradiance_harmonics(sky, 2, false, Mat3d(1)).lowest, -0.1) << place.name;
        const auto windowed = irradiance_harmonics(sky, 2, true, Mat3d(1));
        const double mean = mean_radiance(sky).x;
        for (int i = 0; i < 5000; ++i) {
            const Vec3d d = direction_of_lat_long(std::fmod(0.618034 * i, 1.0), (i + 0.5) / 5000);
            ASSERT_GE(evaluate(windowed, d).x, -1e-7 * mean) << place.name;
        }
    }
}

// Ghosts of too few points cannot be avoided, but they must show in the figures, and go with more
// points.
TEST(Ghosts, ShowInTheFigures) {
    const Environment sky = sky_with_sun(places[5], 1e6f);
    NoProgress progress;
    const auto error_with = [&](int samples) {
        LevelsPlan plan;
        plan.specular = SpecularPlan{.face_size = 16, .levels = 1, .roughness = {}};
        plan.specular->roughness = {RoughnessCurve::Kind::list, {0.6}};
        plan.filter.method = "importance";
        plan.filter.samples = samples;
        const auto levels = filter_levels(sky, plan, progress);
        const double r = 0.6;
        return (*check_specular(levels->specular, {&r, 1}, {sky, Mat3d(1), 256}, progress))[0]
            .figures.rel_rms;
    };
    EXPECT_GT(error_with(64), 0.3);
    EXPECT_LT(error_with(65536), 0.1 * error_with(64));
}

}  // namespace
}  // namespace splitsum::tests
