// How errors fall with the number of samples: as N^-1/2 with random points, nearly as N^-1 with
// Hammersley's, on light that is smooth but for its texels.
#include <gtest/gtest.h>

#include <cmath>

#include "splitsum/filter/methods.h"
#include "splitsum/measure/error_figures.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

struct Case {
    std::string_view method;
    Lobe lobe;
};

const Case cases[] = {{"importance", {LobeKind::ggx, 0.25}},
                      {"importance", {LobeKind::cosine}},
                      {"mis", {LobeKind::ggx, 0.25}},
                      {"mis", {LobeKind::cosine}}};

std::vector<Vec3d> some_directions(int count) {
    std::vector<Vec3d> directions;
    for (int i = 0; i < count; ++i)
        directions.push_back(
            direction_of_lat_long(std::fmod(0.137 + 0.618034 * i, 1.0), (i + 0.5) / count));
    return directions;
}

std::vector<Vec3> filtered(std::string_view method, const Environment& sky, const Lobe& lobe,
                           const FilterPlan& plan, const std::vector<Vec3d>& directions) {
    std::vector<Vec3> result(directions.size());
    find_filter_method(method, lobe.kind)
        ->prepare(sky, {&lobe, 1}, plan)
        ->evaluate(0, {directions, 0}, result);
    return result;
}

// The slope of the line that fits log error over log N best, for N = 64, 128, ... 4096.
double slope_of(const Case& c, PointSequence sequence) {
    const Environment sky = tests::lopsided_sky(512, 0);
    const auto directions = some_directions(64);
    const auto exact = filtered("reference", sky, c.lobe, {}, directions);
    double n = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
    for (int count = 64; count <= 4096; count *= 2) {
        FilterPlan plan;
        plan.samples = count;
        plan.sequence = sequence;
        const double x = std::log(count);
        const double y = std::log(
            error_figures(filtered(c.method, sky, c.lobe, plan, directions), exact).rel_rms);
        n += 1, sum_x += x, sum_y += y, sum_xx += x * x, sum_xy += x * y;
    }
    return (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}

TEST(Slopes, RandomPointsGainWithTheSquareRoot) {
    for (const Case& c : cases) {
        const double slope = slope_of(c, PointSequence::random);
        EXPECT_NEAR(slope, -0.5, 0.06) << c.method << ' ' << c.lobe.alpha;
    }
}

TEST(Slopes, HammersleyPointsGainFaster) {
    for (const Case& c : cases) {
        const double slope = slope_of(c, PointSequence::hammersley);
        EXPECT_LT(slope, -0.75) << c.method << ' ' << c.lobe.alpha;
    }
}

}  // namespace
}  // namespace splitsum
