#include "splitsum/measure/error_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace splitsum {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

using Texels = std::vector<Vec3>;

const Texels reference = {{1, 2, 3}, {4, 0.5f, 0}, {10, 20, 5}};

TEST(ErrorFigures, OfEqualListsAreZero) {
    const ErrorFigures figures = error_figures(reference, reference);
    EXPECT_EQ(figures.rel_rms, 0);
    EXPECT_EQ(figures.max_rel, 0);
    EXPECT_EQ(figures.max_abs, 0);
    EXPECT_EQ(figures.bias, 0);
    EXPECT_EQ(figures.texels, 3);
}

// A common factor is the same relative error in every figure.
TEST(ErrorFigures, OfAFactorAreTheFactor) {
    for (const float factor : {1.01f, 0.99f}) {
        Texels values = reference;
        for (Vec3& value : values) value *= factor;
        const ErrorFigures figures = error_figures(values, reference);
        EXPECT_NEAR(figures.rel_rms, 0.01, 1e-6);
        EXPECT_NEAR(figures.max_rel, 0.01, 1e-6);
        EXPECT_NEAR(figures.bias, factor - 1.0f, 1e-6);
        EXPECT_NEAR(figures.max_abs, 0.2, 1e-5);
    }
}

TEST(ErrorFigures, FollowTheirDefinitions) {
    const Texels values = {{1, 2, 3.3f}, {4, 0.5f, 0.25f}, {10, 16, 5}};
    const double squares = 0.3 * 0.3 + 0.25 * 0.25 + 4 * 4;
    const double reference_squares = 1 + 4 + 9 + 16 + 0.25 + 100 + 400 + 25;
    const ErrorFigures figures = error_figures(values, reference);
    EXPECT_NEAR(figures.rel_rms, std::sqrt(squares / reference_squares), 1e-6);
    EXPECT_NEAR(figures.max_rel, 0.2, 1e-6);  // the 0.25 beside a reference of 0 has no ratio
    EXPECT_NEAR(figures.max_abs, 4, 1e-6);
    EXPECT_NEAR(figures.bias, (0.3 + 0.25 - 4) / 45.5, 1e-6);
}

TEST(ErrorFigures, OfDarkness) {
    const Texels dark(4, Vec3(0));
    Texels light = dark;
    light[2].y = 1e-20f;
    EXPECT_EQ(error_figures(dark, dark).rel_rms, 0);
    EXPECT_EQ(error_figures(dark, dark).bias, 0);
    EXPECT_EQ(error_figures(light, dark).rel_rms, std::numeric_limits<double>::infinity());
    EXPECT_EQ(error_figures(light, dark).bias, std::numeric_limits<double>::infinity());
    EXPECT_EQ(error_figures(dark, light).rel_rms, 1);
    EXPECT_EQ(error_figures(dark, light).bias, -1);
}

// A limit that is checked as !(figure <= limit) must catch a NaN wherever it stands.
TEST(ErrorFigures, NeverGiveNotANumberAGoodFigure) {
    for (size_t i = 0; i < reference.size(); ++i)
        for (int c = 0; c < 3; ++c)
            for (const float bad : {nan, infinity, -infinity}) {
                Texels spoilt = reference;
                spoilt[i][c] = bad;
                for (const ErrorFigures& figures :
                     {error_figures(spoilt, reference), error_figures(reference, spoilt),
                      error_figures(spoilt, spoilt)}) {
                    EXPECT_FALSE(figures.rel_rms <= 1e6) << i << c << bad;
                    EXPECT_FALSE(figures.max_abs <= 1e6) << i << c << bad;
                    EXPECT_FALSE(std::abs(figures.bias) <= 1e6) << i << c << bad;
                }
                if (reference[i][c] > 0) {
                    EXPECT_FALSE(error_figures(spoilt, reference).max_rel <= 1e6);
                }
            }
}

TEST(ErrorFigures, OfTablesAreTheSameFigures) {
    const std::vector<float> table = {0.5f, 0.25f, 1, 0};
    const std::vector<float> other = {0.5f, 0.75f, 1, 0};
    const ErrorFigures figures = error_figures(table, other, 2);
    EXPECT_NEAR(figures.max_abs, 0.5, 1e-7);
    EXPECT_NEAR(figures.max_rel, 2.0 / 3, 1e-7);
    EXPECT_NEAR(figures.rel_rms, 0.5 / std::sqrt(0.25 + 0.5625 + 1), 1e-7);
    EXPECT_EQ(figures.texels, 2);
}

}  // namespace
}  // namespace splitsum
