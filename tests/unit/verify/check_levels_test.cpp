// A check must find nothing in a perfect level and must find what was planted.
#include "splitsum/verify/check_levels.h"

#include <gtest/gtest.h>

#include <numbers>

#include "splitsum/filter/asset_levels.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

struct Made {
    Environment sky = tests::lopsided_sky(32);
    Orientation orientation{40, true, "khronos-sampler"};
    std::vector<double> perceptual_roughness = {0, 0.4, 1};
    AssetLevels levels;

    Made() {
        LevelsPlan plan;
        plan.specular = SpecularPlan{.face_size = 8, .levels = 3, .roughness = {}};
        plan.specular->roughness = {RoughnessCurve::Kind::list, perceptual_roughness};
        plan.irradiance = IrradiancePlan{.face_size = 6};
        plan.filter.method = "reference";
        plan.orientation = orientation;
        NoProgress progress;
        levels = *filter_levels(sky, plan, progress);
    }

    CheckedAgainst truth(int probes) const {
        return {sky, panorama_from_cube(orientation), probes};
    }
    std::vector<LevelCheck> specular(int probes) const {
        NoProgress progress;
        return *check_specular(levels.specular, perceptual_roughness, truth(probes), progress);
    }
    LevelCheck irradiance(int probes, double stored_factor = 1) const {
        NoProgress progress;
        return *check_irradiance(*levels.irradiance, stored_factor, truth(probes), progress);
    }
};

TEST(CheckLevels, FindsNothingInPerfectLevels) {
    const Made made;
    for (const int probes : {7, 64, 100000}) {
        const auto checks = made.specular(probes);
        ASSERT_EQ(checks.size(), 3u);
        EXPECT_LT(checks[0].figures.rel_rms, 5e-3);  // the mirror is compared with 128² points
        EXPECT_LT(checks[1].figures.rel_rms, 1e-7);
        EXPECT_LT(checks[2].figures.rel_rms, 1e-7);
        EXPECT_LT(made.irradiance(probes).figures.rel_rms, 1e-7);
        EXPECT_EQ(checks[0].figures.texels, std::min(probes, 6 * 64));
        EXPECT_EQ(checks[2].figures.texels, std::min(probes, 6 * 4));
        EXPECT_EQ(made.irradiance(probes).figures.texels, std::min(probes, 6 * 36));
    }
}

TEST(CheckLevels, SaysWhichLevelItMeasured) {
    const Made made;
    const auto checks = made.specular(5);
    for (int level = 0; level < 3; ++level) {
        const LevelCheck& check = checks[size_t(level)];
        EXPECT_EQ(check.level, level);
        EXPECT_EQ(check.face_size, 8 >> level);
        EXPECT_EQ(check.perceptual_roughness, made.perceptual_roughness[size_t(level)]);
        EXPECT_EQ(check.mean_radiance, mean_radiance(made.levels.specular[size_t(level)]));
    }
}

TEST(CheckLevels, FindsAPlantedErrorOfOnePercent) {
    Made made;
    for (Cubemap& level : made.levels.specular)
        for (Vec3& texel : level.texels) texel *= 1.01f;
    for (Vec3& texel : made.levels.irradiance->texels) texel *= 1.01f;
    for (const LevelCheck& check : made.specular(20)) {
        if (check.level == 0) continue;
        EXPECT_NEAR(check.figures.rel_rms, 0.01, 1e-5) << check.level;
        EXPECT_NEAR(check.figures.bias, 0.01, 1e-5) << check.level;
        EXPECT_NEAR(check.figures.max_rel, 0.01, 1e-5) << check.level;
    }
    EXPECT_NEAR(made.irradiance(20).figures.rel_rms, 0.01, 1e-5);
}

TEST(CheckLevels, FindsOneWrongTexel) {
    Made made;
    made.levels.specular[1].at(3, 2, 1).y += 1;
    const LevelCheck check = made.specular(100000)[1];
    EXPECT_NEAR(check.figures.max_abs, 1, 1e-5);
}

TEST(CheckLevels, FindsLevelsOfAnotherRoughnessOrOrientation) {
    Made made;
    made.perceptual_roughness[1] = 0.41;
    EXPECT_GT(made.specular(64)[1].figures.rel_rms, 3e-3);
    made = Made();
    made.orientation.rotate_degrees += 1;
    EXPECT_GT(made.specular(64)[1].figures.rel_rms, 5e-3);
    made = Made();
    made.orientation.mirror = false;
    EXPECT_GT(made.irradiance(64).figures.rel_rms, 0.05);
}

TEST(CheckLevels, KnowsWhatIsStored) {
    Made made;
    for (Vec3& texel : made.levels.irradiance->texels) texel *= std::numbers::pi_v<float>;
    EXPECT_LT(made.irradiance(64, std::numbers::pi).figures.rel_rms, 2e-7);
    EXPECT_GT(made.irradiance(64).figures.rel_rms, 1);
}

// The price of a short series: falls with its order, and vanishes for light that has no more bands.
TEST(CheckHarmonics, MeasuresTheShortSeries) {
    const Made made;
    NoProgress progress;
    const auto error_of = [&](const Environment& sky, int order) {
        const CheckedAgainst truth{sky, panorama_from_cube(made.orientation), 64};
        return check_harmonics(irradiance_harmonics(sky, order, false, truth.panorama_from_cube),
                               truth, progress)
            ->figures.rel_rms;
    };
    EXPECT_GT(error_of(made.sky, 0), 0.1);
    EXPECT_LT(error_of(made.sky, 2), 0.5 * error_of(made.sky, 1));
    EXPECT_LT(error_of(made.sky, 12), 2e-3);  // the sun's edge leaves 1.3e-3
    const Environment slope =
        tests::environment_of(128, [](const Vec3d& d) { return Vec3(2 + d.x, 2 + d.y, 2 + d.z); });
    EXPECT_LT(error_of(slope, 1), 1e-4);
}

}  // namespace
}  // namespace splitsum
