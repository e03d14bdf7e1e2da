// The sampling methods with random points; with Hammersley's they are tested beside all methods in
// tests/reference.
#include "splitsum/filter/sampled.h"

#include <gtest/gtest.h>

#include "splitsum/base/parallel.h"
#include "splitsum/filter/filter_cubemap.h"
#include "splitsum/measure/error_figures.h"
#include "support/skies.h"

namespace splitsum {
namespace {

const std::vector<std::string_view> drawing = {"importance", "filtered", "mis"};

FilterPlan random_plan(int samples) {
    FilterPlan plan;
    plan.samples = samples;
    plan.sequence = PointSequence::random;
    return plan;
}

std::unique_ptr<PreparedFilter> prepared(std::string_view method, const Environment& sky,
                                         const Lobe& lobe, const FilterPlan& plan) {
    return find_filter_method(method, lobe.kind)->prepare(sky, {&lobe, 1}, plan);
}

TEST(RandomPoints, GiveTheSameBitsForAnyNumberOfThreads) {
    const Environment sky = tests::lopsided_sky(16);
    NoProgress progress;
    for (const std::string_view method : drawing) {
        const auto bake = [&](int threads) {
            const ThreadLimit limit(threads);
            const auto filter = prepared(method, sky, {LobeKind::ggx, 0.25}, random_plan(64));
            return filter_cubemap(*filter, 0, 16, Mat3d(1), 7, progress)->cubemap.texels;
        };
        EXPECT_EQ(bake(1), bake(8)) << method;
    }
}

// A texel's points come from its key and the seed: not from its direction, nor from its neighbours.
TEST(RandomPoints, AreThoseOfTheTexelAndTheSeed) {
    const Environment sky = tests::studio_sky(32);
    const std::vector<Vec3d> twice = {{0.6, 0, 0.8}, {0.6, 0, 0.8}};
    for (const std::string_view method : drawing) {
        const auto evaluated = [&](uint32_t seed, uint32_t first_key) {
            FilterPlan plan = random_plan(64);
            plan.seed = seed;
            std::vector<Vec3> result(2);
            prepared(method, sky, {LobeKind::ggx, 0.25}, plan)
                ->evaluate(0, {twice, first_key}, result);
            return result;
        };
        const auto first = evaluated(0, 10), next = evaluated(0, 11);
        EXPECT_NE(first[0], first[1]) << method;
        EXPECT_EQ(first[1], next[0]) << method;
        EXPECT_NE(first[0], evaluated(1, 10)[0]) << method;
    }
}

// Measured: up to 1.1e-3. A lobe 5 % too wide must show.
TEST(RandomPoints, AnswerTheSameQuestion) {
    const Environment sky = tests::lopsided_sky(64, 3);
    const std::vector<Vec3d> directions = {
        {0, 1, 0}, {0.48, 0.6, 0.64}, {0.36, -0.48, -0.8}, {-0.6, 0.64, -0.48}};
    const auto values = [&](std::string_view method, const Lobe& lobe) {
        std::vector<Vec3> result(directions.size());
        prepared(method, sky, lobe, random_plan(1 << 18))->evaluate(0, {directions, 0}, result);
        return result;
    };
    constexpr double limit = 0.0018;
    for (const Lobe& lobe : {Lobe{LobeKind::ggx, 0.25}, Lobe{LobeKind::cosine}}) {
        const auto exact = values("reference", lobe);
        for (const std::string_view method : drawing)
            EXPECT_LT(error_figures(values(method, lobe), exact).rel_rms, limit) << method;
    }
    const auto right = values("reference", {LobeKind::ggx, 0.25});
    const auto wide = values("reference", {LobeKind::ggx, 0.2625});
    EXPECT_GT(error_figures(wide, right).rel_rms, limit);
}

TEST(RandomPoints, LeaveTheGridOfRiemannAlone) {
    const Environment sky = tests::lopsided_sky(16);
    const std::vector<Vec3d> directions = {{0.48, 0.6, 0.64}};
    std::vector<Vec3> grid(1), same(1);
    FilterPlan plan = random_plan(64);
    prepared("riemann", sky, {LobeKind::cosine}, plan)->evaluate(0, {directions, 0}, grid);
    plan.sequence = PointSequence::hammersley;
    prepared("riemann", sky, {LobeKind::cosine}, plan)->evaluate(0, {directions, 0}, same);
    EXPECT_EQ(grid, same);
}

}  // namespace
}  // namespace splitsum
