// Multiple importance sampling is unbiased: the mean of many runs is the exact integral within its
// own standard error, and the test that says so rejects weights that do not add up to one.
#include "splitsum/filter/mis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "splitsum/filter/mis_estimate.h"
#include "support/skies.h"

namespace splitsum {
namespace {

constexpr uint32_t runs = 64;
constexpr int samples = 256;

// In standard errors. Seeds are fixed; 576 figures are looked at, a third of them independent, and the
// farthest lies 3.4 off. Mutants that were caught: densities swapped in one strategy, rows drawn
// without their solid angle, half vectors beyond 45 degrees counted in the density.
constexpr double limit = 4;

struct Subject {
    std::string_view name;
    Environment (*make)(int height);
};

Environment sun_sky(int height) {
    Environment sky = tests::lopsided_sky(height, 0);
    sky.set_texel(height / 2 + 3, height / 3, Vec3(1e5f, 6e4f, 2e4f));
    return sky;
}

// All directions but one texel's are alike. Of a perfect constant nothing is left to sample.
Environment constant_sky(int height) {
    Environment sky =
        tests::environment_of(height, [](const Vec3d&) { return Vec3(0.5f, 1.0f, 4.0f); });
    sky.set_texel(1, 2, Vec3(0));
    return sky;
}

constexpr Subject subjects[] = {
    {"sun", sun_sky}, {"studio", tests::studio_sky}, {"constant", constant_sky}};

const std::vector<Vec3d> directions = {
    {0, 1, 0}, {0.48, 0.6, 0.64}, {0.36, -0.48, -0.8}, {-0.6, 0.64, -0.48}};

std::vector<Lobe> lobes() {
    std::vector<Lobe> all = {{LobeKind::cosine}};
    for (const double r : {0.05, 0.3, 1.0}) all.push_back({LobeKind::ggx, r * r});
    return all;
}

std::vector<Vec3> exact_values(const Environment& sky, const Lobe& lobe) {
    std::vector<Vec3> exact(directions.size());
    find_filter_method("reference", LobeKind::ggx)
        ->prepare(sky, {&lobe, 1}, {})
        ->evaluate(0, {directions, 0}, exact);
    return exact;
}

// The farthest that the mean of the runs lies from the truth, in standard errors of that mean by
// the spread of the runs. `estimate(direction, run)` is one run; rounding to float is let pass.
template <class Estimate>
double farthest(const std::vector<Vec3>& exact, const Estimate& estimate) {
    double result = 0;
    for (size_t i = 0; i < directions.size(); ++i) {
        SampleMoments moments;
        for (uint32_t run = 0; run < runs; ++run) moments.add(estimate(i, run));
        const Vec3d miss = moments.mean() - Vec3d(exact[i]);
        const Vec3d error = sqrt(moments.variance_of_mean());
        for (int c = 0; c < 3; ++c) {
            const double rounding = 1e-6 * double(exact[i][c]);
            result = std::max(
                result, std::max(0.0, std::abs(miss[c]) - rounding) / std::max(error[c], 1e-30));
        }
    }
    return result;
}

double farthest_of_method(const Environment& sky, const Lobe& lobe, const FilterPlan& plan) {
    std::vector<std::vector<Vec3>> of_run(runs, std::vector<Vec3>(directions.size()));
    for (uint32_t run = 0; run < runs; ++run) {
        FilterPlan seeded = plan;
        seeded.seed = run;
        prepare_mis(sky, {&lobe, 1}, seeded)->evaluate(0, {directions, 0}, of_run[run]);
    }
    return farthest(exact_values(sky, lobe),
                    [&](size_t i, uint32_t run) { return Vec3d(of_run[run][i]); });
}

TEST(Mis, IsUnbiased) {
    for (const Subject& subject : subjects) {
        const Environment sky = subject.make(64);
        for (const Lobe& lobe : lobes())
            for (const NamedValue<PointSequence>& sequence : point_sequences())
                for (const NamedValue<MisHeuristic>& heuristic : mis_heuristics()) {
                    FilterPlan plan{.samples = samples};
                    plan.sequence = sequence.value;
                    plan.heuristic = heuristic.value;
                    EXPECT_LT(farthest_of_method(sky, lobe, plan), limit)
                        << subject.name << ", alpha " << lobe.alpha << ", " << sequence.name << ", "
                        << heuristic.name;
                }
    }
}

// The same runs with weights of one's own.
template <class Share>
double farthest_with(const Environment& sky, const Lobe& lobe, const Share& share) {
    const LightSampler light(sky);
    const LobeSampler sampler(lobe);
    return farthest(exact_values(sky, lobe), [&](size_t i, uint32_t run) {
        const MisPoints points(light, samples, PointSequence::hammersley, {run, uint32_t(i)});
        return mis_estimate(light, sampler, directions[i], points, share).mean;
    });
}

// A slip in the power heuristic: the sum is squared, not the summands.
struct SquareOfSum {
    double operator()(double own, double other) const { return std::pow(own / (own + other), 2); }
};

// Densities compared without the numbers of samples, of which the light has three times as many in
// its own eyes: any asymmetry between the two strategies.
struct Lopsided {
    double operator()(double own, double other) const { return own / (own + 3 * other); }
};

TEST(Mis, TheTestNoticesWeightsThatDoNotAddUp) {
    for (const Subject& subject : subjects) {
        const Environment sky = subject.make(64);
        for (const double r : {0.3, 1.0}) {
            const Lobe lobe{LobeKind::ggx, r * r};
            EXPECT_LT(farthest_with(sky, lobe, PowerShare()), limit) << subject.name << r;
            EXPECT_GT(farthest_with(sky, lobe, SquareOfSum()), 2 * limit) << subject.name << r;
            EXPECT_GT(farthest_with(sky, lobe, Lopsided()), 2 * limit) << subject.name << r;
        }
    }
}

// rms over directions and channels of what standard_errors says, and of what runs differ by.
struct Spread {
    double stated = 0;
    double actual = 0;
};

Spread spread_of(const Environment& sky, const Lobe& lobe, PointSequence sequence) {
    Spread spread;
    std::vector<SampleMoments> moments(directions.size());
    for (uint32_t run = 0; run < 4 * runs; ++run) {
        FilterPlan plan{.samples = samples};
        plan.seed = run;
        plan.sequence = sequence;
        const auto filter = prepare_mis(sky, {&lobe, 1}, plan);
        std::vector<Vec3> values(directions.size());
        filter->evaluate(0, {directions, 0}, values);
        const auto errors = filter->standard_errors(0, {directions, 0});
        for (size_t i = 0; i < directions.size(); ++i) {
            moments[i].add(Vec3d(values[i]));
            spread.stated += double(dot(errors[i], errors[i])) / (4 * runs);
        }
    }
    for (const SampleMoments& moment : moments) {
        const Vec3d variance = moment.variance_of_mean() * (4.0 * runs);
        spread.actual += variance.x + variance.y + variance.z;
    }
    return {std::sqrt(spread.stated), std::sqrt(spread.actual)};
}

// With random points what is stated is what happens; evenly spread ones do better.
TEST(Mis, KnowsItsStandardError) {
    for (const Subject& subject : subjects) {
        const Environment sky = subject.make(64);
        for (const double r : {0.3, 1.0}) {
            const Lobe lobe{LobeKind::ggx, r * r};
            const Spread random = spread_of(sky, lobe, PointSequence::random);
            EXPECT_NEAR(random.stated / random.actual, 1, 0.15) << subject.name << ' ' << r;
            const Spread even = spread_of(sky, lobe, PointSequence::hammersley);
            EXPECT_GT(even.stated, 1.2 * even.actual) << subject.name << ' ' << r;
        }
    }
}

}  // namespace
}  // namespace splitsum
