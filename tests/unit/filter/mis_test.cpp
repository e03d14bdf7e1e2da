// Multiple importance sampling: what it draws from, and what it promises as a method. That it is
// unbiased is shown in tests/statistical.
#include "splitsum/filter/mis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "splitsum/filter/mis_estimate.h"
#include "splitsum/math/quadrature.h"
#include "support/skies.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<Lobe> some_lobes() {
    std::vector<Lobe> lobes = {{LobeKind::cosine}};
    for (const double alpha : {1e-8, 1e-4, 0.0025, 0.09, 0.5, 1.0})
        lobes.push_back({LobeKind::ggx, alpha});
    return lobes;
}

// The share of a lobe's density within `radius` of its peak, by Gauss-Legendre on growing panels.
template <class Density>
double mass_within(const Lobe& lobe, double radius, const Density& density) {
    static const QuadratureRule rule = gauss_legendre(32);
    double sum = 0;
    for (double from = 0; from < radius;) {
        const double to = std::min(radius, from + 0.5 * std::max(from, lobe_width(lobe)));
        sum += integrate(rule, from, to, [&](double theta) {
            const double half = std::sin(0.5 * theta);
            return 2 * pi * std::sin(theta) * density(2 * half * half);
        });
        from = to;
    }
    return sum;
}

TEST(LobeSampler, DensityAndValueIntegrateToOne) {
    for (const Lobe& lobe : some_lobes()) {
        const LobeSampler sampler(lobe);
        const auto pdf = [&](double versine) { return sampler.pdf(versine); };
        const auto value = [&](double versine) { return sampler.value(versine); };
        EXPECT_NEAR(mass_within(lobe, 0.5 * pi, pdf), 1, 1e-9) << lobe.alpha;
        EXPECT_NEAR(mass_within(lobe, 0.5 * pi, value), 1, 1e-9) << lobe.alpha;
        EXPECT_EQ(sampler.pdf(1.5), 0);
    }
}

// Sample and density are a pair: u.x is the share of the density within the sampled angle.
TEST(LobeSampler, InvertsItsDistribution) {
    for (const Lobe& lobe : some_lobes()) {
        const LobeSampler sampler(lobe);
        for (const double u : {0.01, 0.3, 0.5, 0.9, 0.999}) {
            const auto [direction, versine] = sampler.sample({u, 0.3});
            const double radius = 2 * std::asin(std::sqrt(0.5 * versine));
            const auto pdf = [&](double v) { return sampler.pdf(v); };
            EXPECT_NEAR(mass_within(lobe, radius, pdf), u, 1e-8) << lobe.alpha;
            EXPECT_NEAR(length(direction), 1, 1e-14);
            EXPECT_NEAR(std::hypot(direction.x, direction.y) / std::sin(radius), 1, 1e-8);
        }
        const double last = sampler.sample({std::nextafter(1.0, 0.0), 0.3}).versine;
        EXPECT_GT(sampler.pdf(last), 0) << lobe.alpha;
    }
}

TEST(LightSampler, DensityIntegratesToOne) {
    for (const tests::NamedSky& named : tests::skies()) {
        const Environment sky = named.make(32);
        const LightSampler light(sky);
        double sum = 0;
        for (int y = 0; y < sky.height(); ++y)
            for (int x = 0; x < sky.width(); ++x) {
                const auto texel = light.towards(direction_of_lat_long((x + 0.5) / sky.width(),  //
                                                                       (y + 0.5) / sky.height()));
                EXPECT_GE(texel.pdf, 0);
                EXPECT_EQ(Vec3(texel.light + light.floor()), sky.texel(x, y));
                sum += texel.pdf * solid_angle_of_row(y, sky.height());
            }
        EXPECT_NEAR(sum, 1, 1e-12) << named.name;
    }
}

// A rectangle of u is mapped to as much of the density; so points of a fine grid are spread over
// texels in proportion to it, and what sample() says agrees with towards().
TEST(LightSampler, InvertsItsDistribution) {
    const Environment sky = tests::lopsided_sky(8, 5);
    const LightSampler light(sky);
    constexpr int grid = 1000;
    std::vector<int> counts(size_t(sky.width() * sky.height()), 0);
    for (int j = 0; j < grid; ++j)
        for (int i = 0; i < grid; ++i) {
            const auto sample = light.sample({(i + 0.5) / grid, (j + 0.5) / grid});
            const LatLong at = lat_long_towards(sample.direction);
            const int x = int(at.u * sky.width()), y = int(at.v * sky.height());
            ++counts[size_t(y * sky.width() + x)];
            ASSERT_EQ(sample.pdf, light.towards(sample.direction).pdf);
        }
    for (int y = 0; y < sky.height(); ++y)
        for (int x = 0; x < sky.width(); ++x) {
            const auto texel = light.towards(
                direction_of_lat_long((x + 0.5) / sky.width(), (y + 0.5) / sky.height()));
            const double share = texel.pdf * solid_angle_of_row(y, sky.height());
            const double counted = double(counts[size_t(y * sky.width() + x)]) / grid / grid;
            EXPECT_NEAR(counted, share, 3e-3 * std::sqrt(share) + 1e-5) << x << ", " << y;
        }
}

// Uniform over the texel's solid angle is uniform in the cosine: from 1 to 0 in the upper of two
// rows, 1/2 in the mean. Uniform in the angle it would be 2 / pi.
TEST(LightSampler, IsUniformOverATexelsSolidAngle) {
    Environment sky(2);
    sky.set_texel(1, 0, Vec3(1));
    const LightSampler light(sky);
    constexpr int grid = 100;
    double cosines = 0, columns = 0;
    for (int i = 0; i < grid; ++i) {
        const double u = (i + 0.5) / grid;
        const Vec3d direction = light.sample({u, u}).direction;
        cosines += direction.y / grid;
        columns += lat_long_towards(direction).u * 4 / grid;
    }
    EXPECT_NEAR(cosines, 0.5, 1e-12);
    EXPECT_NEAR(columns, 1.5, 1e-12);
}

TEST(LightSampler, FindsTheOnlyTexel) {
    for (const int row : {0, 17, 31}) {
        Environment sky(32);
        sky.set_texel(63, row, Vec3(0, 0, 1e-3f));
        const LightSampler light(sky);
        for (const double u : {0.0, 0.5, std::nextafter(1.0, 0.0)}) {
            const auto sample = light.sample({u, u});
            EXPECT_NEAR(sample.pdf * solid_angle_of_row(row, 32), 1, 1e-12);
            EXPECT_EQ(sample.light, Vec3d(Vec3(0, 0, 1e-3f)));
        }
    }
}

TEST(MisShares, AddUpToOne) {
    for (const double a : {1e-12, 0.3, 1.0, 1e15})
        for (const double b : {1e-12, 0.7, 1e9}) {
            EXPECT_NEAR(PowerShare()(a, b) + PowerShare()(b, a), 1, 1e-15);
            EXPECT_NEAR(BalanceShare()(a, b) + BalanceShare()(b, a), 1, 1e-15);
        }
    EXPECT_EQ(PowerShare()(2, 0), 1);
    EXPECT_NEAR(PowerShare()(1, 2), 0.2, 1e-15);
    EXPECT_NEAR(BalanceShare()(1, 3), 0.25, 1e-15);
}

std::vector<Vec3> filtered(const Environment& sky, const FilterPlan& plan, const Lobe& lobe,
                           const std::vector<Vec3d>& directions) {
    std::vector<Vec3> result(directions.size());
    prepare_mis(sky, {&lobe, 1}, plan)->evaluate(0, {directions, 0}, result);
    return result;
}

// Where importance sampling sees ghosts and light sampling alone sees noise.
TEST(Mis, FindsASmallSunWithFewSamples) {
    Environment sky(256);
    const Vec3d sun = direction_of_lat_long(300.5 / 512, 90.5 / 256);
    sky.set_texel(300, 90, Vec3(1e6f));
    const std::vector<Vec3d> directions = {normalize(sun + Vec3d(0, 0.3, 0.1))};
    for (const double r : {0.3, 0.6, 1.0}) {
        const Lobe lobe{LobeKind::ggx, r * r};
        std::vector<Vec3> exact(1);
        find_filter_method("reference", LobeKind::ggx)
            ->prepare(sky, {&lobe, 1}, {})
            ->evaluate(0, {directions, 0}, exact);
        FilterPlan plan;
        plan.samples = 32;
        EXPECT_NEAR(filtered(sky, plan, lobe, directions)[0].x / exact[0].x, 1, 0.02) << r;
    }
}

TEST(Mis, IsLightForAnyNumberOfSamples) {
    for (const PointSequence sequence : {PointSequence::hammersley, PointSequence::random})
        for (const int count : {1, 2, 3, 16, 17}) {
            FilterPlan plan;
            plan.samples = count;
            plan.sequence = sequence;
            for (const Lobe& lobe : some_lobes())
                for (const Vec3& v : filtered(tests::studio_sky(16), plan, lobe, {{0, 1, 0}}))
                    for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(v[c]) && v[c] >= 0);
        }
}

TEST(Mis, ChangesWithItsSeedSequenceAndHeuristic) {
    const Environment sky = tests::studio_sky(32);
    const Lobe lobe{LobeKind::ggx, 0.25};
    const FilterPlan plan{.samples = 64};
    FilterPlan seed = plan, sequence = plan, heuristic = plan;
    seed.seed = 1;
    sequence.sequence = PointSequence::random;
    heuristic.heuristic = MisHeuristic::balance;
    const std::vector<Vec3d> directions = {{0.6, 0, 0.8}, {0, 0.6, 0.8}};
    const auto of = [&](const FilterPlan& p) { return filtered(sky, p, lobe, directions); };
    EXPECT_EQ(of(plan), of(plan));
    for (const FilterPlan& other : {seed, sequence, heuristic}) EXPECT_NE(of(plan), of(other));
}

TEST(Mis, SplitsItsSamples) {
    const Environment sky = tests::lopsided_sky(8), grey(8);
    for (const int count : {1, 2, 3, 100, 101}) {
        const MisPoints points(LightSampler(sky), count, PointSequence::hammersley, {});
        EXPECT_EQ(points.lobe_count + points.light_count, count);
        EXPECT_EQ(points.light_count, count / 2);
        EXPECT_NE(points.lobe[0], points.light[0]);
        const MisPoints flat(LightSampler(grey), count, PointSequence::random, {});
        EXPECT_EQ(flat.lobe_count, count);
    }
}

TEST(Mis, OnlyItStatesItsStandardError) {
    const Environment sky = tests::lopsided_sky(16);
    const Lobe lobe{LobeKind::ggx, 0.25};
    const std::vector<Vec3d> directions = {{0, 0, 1}, {0, 1, 0}};
    for (const FilterMethod& method : filter_methods()) {
        if (!method.filters_ggx) continue;
        const auto errors =
            method.prepare(sky, {&lobe, 1}, {})->standard_errors(0, {directions, 0});
        EXPECT_EQ(errors.size(), method.name == "mis" ? 2u : 0u) << method.name;
    }
}

}  // namespace
}  // namespace splitsum
