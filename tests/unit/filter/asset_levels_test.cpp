#include "splitsum/filter/asset_levels.h"

#include <gtest/gtest.h>

#include <numbers>

#include "splitsum/filter/methods.h"
#include "splitsum/sphere/area_filter.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

LevelsPlan small_plan() {
    LevelsPlan plan;
    plan.specular = SpecularPlan{.face_size = 16, .levels = 4, .roughness = {}};
    plan.irradiance = IrradiancePlan{.face_size = 4};
    plan.filter.samples = 64;
    return plan;
}

AssetLevels levels_of(const Environment& sky, const LevelsPlan& plan) {
    NoProgress progress;
    auto levels = filter_levels(sky, plan, progress);
    EXPECT_TRUE(levels) << (levels ? "" : levels.error().message);
    return levels ? std::move(*levels) : AssetLevels{};
}

TEST(FilterLevels, HalvesTheSizeFromLevelToLevel) {
    const AssetLevels levels = levels_of(tests::lopsided_sky(16), small_plan());
    ASSERT_EQ(levels.specular.size(), 4u);
    for (size_t level = 0; level < 4; ++level)
        EXPECT_EQ(levels.specular[level].face_size, 16 >> level);
    ASSERT_TRUE(levels.irradiance);
    EXPECT_EQ(levels.irradiance->face_size, 4);
}

TEST(FilterLevels, LevelsOfRoughnessZeroAreTheMirrorImageWhateverTheMethod) {
    const Environment sky = tests::lopsided_sky(16);
    LevelsPlan plan = small_plan();
    plan.irradiance.reset();
    plan.orientation = {25, true, "cmgen"};
    plan.specular->levels = 2;
    plan.specular->roughness = {RoughnessCurve::Kind::list, {0, 0}};
    NoProgress progress;
    for (const FilterMethod& method : filter_methods()) {
        if (!method.filters_ggx) continue;
        plan.filter.method = method.name;
        const AssetLevels levels = levels_of(sky, plan);
        for (const Cubemap& level : levels.specular) {
            const auto mirror = area_filtered_cubemap(
                sky, level.face_size, panorama_from_cube(plan.orientation), progress);
            ASSERT_TRUE(mirror);
            EXPECT_EQ(level.texels, mirror->texels) << method.name << " " << level.face_size;
        }
    }
}

TEST(FilterLevels, AskedTogetherAndAskedAloneAreTheSame) {
    const Environment sky = tests::lopsided_sky(16);
    const LevelsPlan plan = small_plan();
    LevelsPlan specular = plan, irradiance = plan;
    specular.irradiance.reset();
    irradiance.specular.reset();
    const AssetLevels both = levels_of(sky, plan);
    const AssetLevels chain = levels_of(sky, specular), diffuse = levels_of(sky, irradiance);
    ASSERT_EQ(chain.specular.size(), both.specular.size());
    for (size_t level = 0; level < both.specular.size(); ++level)
        EXPECT_EQ(chain.specular[level].texels, both.specular[level].texels);
    EXPECT_FALSE(chain.irradiance);
    EXPECT_TRUE(diffuse.specular.empty());
    EXPECT_EQ(diffuse.irradiance->texels, both.irradiance->texels);
}

TEST(FilterLevels, StoresEOnRequest) {
    const Environment sky = tests::lopsided_sky(16);
    LevelsPlan plan = small_plan();
    const AssetLevels over_pi = levels_of(sky, plan);
    plan.irradiance->store_irradiance = true;
    const AssetLevels whole = levels_of(sky, plan);
    for (size_t i = 0; i < whole.irradiance->texels.size(); ++i)
        EXPECT_EQ(whole.irradiance->texels[i],
                  over_pi.irradiance->texels[i] * std::numbers::pi_v<float>);
}

TEST(FilterLevels, RefusesWhatCannotWork) {
    const Environment sky = tests::lopsided_sky(4);
    NoProgress progress;
    const auto expect_refused = [&](const LevelsPlan& plan, const char* found) {
        const auto levels = filter_levels(sky, plan, progress);
        ASSERT_FALSE(levels) << found;
        EXPECT_EQ(levels.error().kind, ErrorKind::bad_argument);
        EXPECT_NE(levels.error().message.find(found), std::string::npos) << levels.error().message;
    };
    LevelsPlan plan = small_plan();
    plan.filter.method = "riemann";  // filters diffuse light alone
    expect_refused(plan, "riemann");
    plan = small_plan();
    plan.filter.method = "guess";
    expect_refused(plan, "there are: ");
    plan = small_plan();
    plan.specular->levels = 6;
    expect_refused(plan, "got 6");
    plan = small_plan();
    plan.orientation.convention = "none";
    expect_refused(plan, "none");
    plan = small_plan();
    plan.filter.samples = 0;
    expect_refused(plan, "got 0");
}

class Cancelled final : public Progress {
public:
    void begin(std::string_view, int) override {}
    void advance(int) override {}
    bool cancelled() const override { return true; }
};

TEST(FilterLevels, EndsWhenCancelled) {
    Cancelled progress;
    const auto levels = filter_levels(tests::lopsided_sky(4), small_plan(), progress);
    ASSERT_FALSE(levels);
    EXPECT_EQ(levels.error().kind, ErrorKind::interrupted);
}

}  // namespace
}  // namespace splitsum
