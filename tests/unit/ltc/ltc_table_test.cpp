#include "splitsum/ltc/ltc_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "splitsum/base/parallel.h"

namespace splitsum {
namespace {

struct Fitted {
    int size;
    std::vector<LtcFit> fits;

    // Texel of roughness x / (size - 1) and sqrt(1 - n·v) = y / (size - 1).
    std::array<double, 5> at(int x, int y) const {
        const auto& [m, magnitude] = fits[static_cast<size_t>(x * size + y)];
        return {m.m00, m.m20, m.m02, m.m22, magnitude};
    }
};

Fitted fit(LtcTarget target, int size, Progress& progress) {
    std::vector<double> n_dot_v, perceptual_roughness;
    for (int i = 0; i < size; ++i) {
        const double coordinate = i / (size - 1.0);
        n_dot_v.push_back(1 - coordinate * coordinate);
        perceptual_roughness.push_back(coordinate);
    }
    auto fits = fit_ltc_table(target, n_dot_v, perceptual_roughness, progress);
    return {size, fits ? *fits : std::vector<LtcFit>{}};
}

// A 24-bit-exponent-range number as a half float has it: 11 bits, and steps of 2^-24 near 0.
double as_half(double x) {
    const int exponent = std::max(std::ilogb(x == 0 ? 1e-30 : x), -14);
    return std::ldexp(std::nearbyint(std::ldexp(x, 10 - exponent)), exponent - 10);
}

class EveryTarget : public testing::TestWithParam<LtcTarget> {};

INSTANTIATE_TEST_SUITE_P(Ltc, EveryTarget,
                         testing::Values(LtcTarget::ggx, LtcTarget::disney_diffuse));

TEST_P(EveryTarget, MatricesAreFiniteAndNeverTurnInsideOutEvenInHalfFloats) {
    NoProgress progress;
    const Fitted table = fit(GetParam(), 33, progress);
    for (const auto& [m, magnitude] : table.fits) {
        EXPECT_NEAR(magnitude, 1, LtcFit::most_change + 1e-12);
        for (const double entry : {m.m00, m.m20, m.m02, m.m22}) ASSERT_TRUE(std::isfinite(entry));
        EXPECT_GT(determinant(m), 0);
        EXPECT_GT(determinant({as_half(m.m00), as_half(m.m20), as_half(m.m02), as_half(m.m22)}), 0);
    }
}

// Second differences along both axes: a fit that ended in another valley than its neighbour stands
// out. Measured at 64: 0.05, in m22 at the most grazing rows (the published table has 0.07); a table
// with one row fitted from a wrong start had 0.7.
TEST_P(EveryTarget, NeighboursDifferSmoothly) {
    NoProgress progress;
    const Fitted table = fit(GetParam(), 64, progress);
    double worst = 0;
    for (int i = 1; i < 63; ++i)
        for (int j = 0; j < 64; ++j)
            for (size_t c = 0; c < 5; ++c) {
                const auto second = [&](double before, double here, double after) {
                    worst = std::max(worst, std::abs(before - 2 * here + after));
                };
                second(table.at(i - 1, j)[c], table.at(i, j)[c], table.at(i + 1, j)[c]);
                second(table.at(j, i - 1)[c], table.at(j, i)[c], table.at(j, i + 1)[c]);
            }
    RecordProperty("largest_second_difference", std::to_string(worst));
    EXPECT_LT(worst, 0.07);
}

TEST_P(EveryTarget, IsTheSameForEveryNumberOfThreads) {
    const auto with = [&](int threads) {
        const ThreadLimit limit(threads);
        NoProgress progress;
        return fit(GetParam(), 9, progress);
    };
    const Fitted one = with(1), four = with(4);
    for (int x = 0; x < 9; ++x)
        for (int y = 0; y < 9; ++y) EXPECT_EQ(one.at(x, y), four.at(x, y));
}

// At grazing views of a rough surface a lobe that is a little weaker shades better, and one that is not
// free to be so is exactly as strong as its target.
TEST(FitLtcTable, FindsAMagnitudeBelowTheAlbedoAtGrazingViews) {
    const double n_dot_v = 0.03, rough = 0.8;
    NoProgress progress;
    const auto table = fit_ltc_table(LtcTarget::ggx, {&n_dot_v, 1}, {&rough, 1}, progress);
    EXPECT_LT(table->front().magnitude, 0.995);
}

// However far apart the rows are, fits walk in strides that they can follow.
TEST(FitLtcTable, DoesNotDependOnTheSpacingOfItsRows) {
    NoProgress progress;
    const Fitted coarse = fit(LtcTarget::ggx, 5, progress),
                 fine = fit(LtcTarget::ggx, 33, progress);
    for (int x = 0; x < 5; ++x)
        for (int y = 0; y < 5; ++y)
            for (size_t c = 0; c < 5; ++c)
                EXPECT_NEAR(coarse.at(x, y)[c], fine.at(8 * x, 8 * y)[c], 0.02)
                    << x << " " << y << " " << c;
}

TEST(FitLtcTable, StopsWhenCancelled) {
    struct Impatient final : Progress {
        void begin(std::string_view, int) override {}
        void advance(int) override {}
        bool cancelled() const override { return true; }
    } progress;
    const double one = 1;
    const auto table = fit_ltc_table(LtcTarget::ggx, {&one, 1}, {&one, 1}, progress);
    ASSERT_FALSE(table);
    EXPECT_EQ(table.error().kind, ErrorKind::interrupted);
}

}  // namespace
}  // namespace splitsum
