#include "splitsum/plan/roughness_curve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace splitsum {
namespace {

using Kind = RoughnessCurve::Kind;

std::vector<RoughnessCurve> curves() {
    return {{Kind::linear, {}}, {Kind::filament, {}}, {Kind::list, {0.1, 0.15, 0.4, 0.75, 0.9}}};
}

TEST(RoughnessCurve, LevelAndRoughnessAreInverse) {
    for (const RoughnessCurve& curve : curves()) {
        const auto roughness = roughness_of_levels(curve, 5);
        ASSERT_EQ(roughness.size(), 5u);
        for (size_t level = 0; level < roughness.size(); ++level)
            EXPECT_NEAR(level_of_roughness(curve, 5, roughness[level]), static_cast<double>(level),
                        1e-14)
                << to_string(curve);
    }
}

TEST(RoughnessCurve, FormulasAreThoseOfTheEngines) {
    const auto linear = roughness_of_levels({Kind::linear, {}}, 7);
    const auto filament = roughness_of_levels({Kind::filament, {}}, 7);
    for (int level = 0; level < 7; ++level) {
        const double lod = level / 6.0;
        EXPECT_DOUBLE_EQ(linear[static_cast<size_t>(level)], lod);
        EXPECT_NEAR(filament[static_cast<size_t>(level)], 1 - std::sqrt(1 - lod), 1e-15);
    }
}

TEST(RoughnessCurve, LevelsRiseAndStayInTheChain) {
    for (const RoughnessCurve& curve : curves()) {
        double previous = 0;
        for (double r = -0.5; r < 1.5; r += 0.001) {
            const double level = level_of_roughness(curve, 5, r);
            EXPECT_GE(level, previous) << to_string(curve) << " at " << r;
            EXPECT_LE(level, 4);
            previous = level;
        }
    }
}

TEST(RoughnessCurve, AListMayRepeatAValue) {
    const RoughnessCurve curve{Kind::list, {0, 0.5, 1, 1}};
    EXPECT_TRUE(validate(curve));
    EXPECT_EQ(level_of_roughness(curve, 4, 1), 2);
    EXPECT_EQ(level_of_roughness(curve, 4, 0.75), 1.5);
}

TEST(RoughnessCurve, ASingleLevelIsTheMirror) {
    for (const Kind kind : {Kind::linear, Kind::filament}) {
        EXPECT_EQ(roughness_of_levels({kind, {}}, 1), std::vector<double>{0});
        EXPECT_EQ(level_of_roughness({kind, {}}, 1, 0.7), 0);
    }
}

TEST(RoughnessCurve, TextReadsBackToTheLastBit) {
    for (RoughnessCurve curve : curves()) {
        if (curve.kind == Kind::list) curve.list = {1e-7, 1.0 / 3, 0.5, 1 - 1e-16, 1};
        const auto again = parse_roughness_curve(to_string(curve));
        ASSERT_TRUE(again) << again.error().message;
        EXPECT_EQ(again->kind, curve.kind);
        EXPECT_EQ(again->list, curve.list);
    }
}

// The shader's reading, written a second time: at each level's own roughness it reads that level.
TEST(RoughnessCurve, BabylonReadsTheLevelsWhereTheyAre) {
    for (const int face_size : {64, 256, 1024}) {
        const int levels = static_cast<int>(std::ceil(0.8 * std::log2(face_size))) + 1;
        const RoughnessCurve curve = babylon_curve(face_size, levels);
        ASSERT_TRUE(validate(curve));
        ASSERT_EQ(curve.list.size(), static_cast<size_t>(levels));
        EXPECT_EQ(curve.list.front(), 0);
        EXPECT_GT(curve.list.back(), 0.9997);
        for (int level = 1; level < levels - 1; ++level) {
            const double r = curve.list[static_cast<size_t>(level)];
            EXPECT_LT(r, 1);
            EXPECT_NEAR(0.8 * std::log2(face_size * (r * r + 0.0005)), level, 1e-12) << face_size;
        }
    }
}

TEST(RoughnessCurve, BabylonDependsOnTheChainAndTheOthersDoNot) {
    EXPECT_EQ(parse_roughness_curve_of_chain("babylon", 128, 5)->list, babylon_curve(128, 5).list);
    EXPECT_EQ(parse_roughness_curve_of_chain("filament", 128, 5)->kind, Kind::filament);
    EXPECT_FALSE(parse_roughness_curve_of_chain("Babylon", 128, 5));
    EXPECT_FALSE(parse_roughness_curve("babylon")) << "needs the size";
}

// However small or long the chain, values stay in [0, 1].
TEST(RoughnessCurve, BabylonFitsEveryChain) {
    for (const int face_size : {1, 2, 8192})
        for (int levels = 1; levels <= 14; ++levels)
            EXPECT_TRUE(validate(babylon_curve(face_size, levels))) << face_size << " " << levels;
}

TEST(RoughnessCurve, RefusesWhatIsNotACurve) {
    for (const char* text : {"", "Linear", "0,", ",0", "0;1", "0,1,0.5", "-0.1,1", "0,1.01",
                             "nan,1", "0, 1", "0,1x"}) {
        const auto curve = parse_roughness_curve(text);
        ASSERT_FALSE(curve) << text;
        EXPECT_EQ(curve.error().kind, ErrorKind::bad_argument);
    }
}

}  // namespace
}  // namespace splitsum
