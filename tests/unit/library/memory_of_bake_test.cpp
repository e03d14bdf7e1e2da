#include "splitsum/library/memory_of_bake.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "splitsum/filter/spectral.h"

namespace splitsum {
namespace {

constexpr double mib = 1 << 20;

BakePlan plan_of(const std::string& method, int face_size, int levels, RoughnessCurve::Kind curve) {
    BakePlan plan;
    plan.filter.method = method;
    plan.specular = {face_size, levels, {curve, {}}};
    return plan;
}

double mib_of(int width, const BakePlan& plan, int threads = 4) {
    return double(memory_of_bake({width, width / 2}, plan, threads)) / mib;
}

/// Peaks of splitsum-bake on 4 threads beyond its start, in MiB, with 32 samples where a method
/// samples: a capture of 1024 x 512, and generated skies of noise under a sun of 5e4.
struct Measured {
    int width;
    std::string method;
    bool fine;  ///< 512² with 9 levels, filament; else 256² with 7 levels, linear
    double peak;
    double peak_of_point = 0;  ///< of a single lit texel in darkness, where bands are kept
};

class MemoryOfBake : public testing::TestWithParam<Measured> {};

const Measured measured[] = {
    {1024, "auto", false, 44, 75},   {1024, "auto", true, 459, 562},
    {2048, "auto", true, 436, 737},  {4096, "auto", false, 56, 60},
    {4096, "auto", true, 426, 737},  {8192, "auto", false, 69, 75},
    {8192, "auto", true, 442, 785},  {16384, "auto", false, 86, 130},
    {16384, "auto", true, 461, 794}, {1024, "importance", false, 40},
    {1024, "importance", true, 88},  {1024, "filtered", false, 51},
    {1024, "filtered", true, 98},    {2048, "importance", true, 127},
    {2048, "filtered", true, 168},   {1024, "mis", false, 44},
    {2048, "mis", true, 143},        {8192, "importance", false, 893},
    {8192, "filtered", false, 1187}, {8192, "filtered", true, 1215},
    {8192, "mis", true, 894},
};

INSTANTIATE_TEST_SUITE_P(Peaks, MemoryOfBake, testing::ValuesIn(measured));

// Enough, and not so much that threads would idle for memory that no light needs.
TEST_P(MemoryOfBake, IsWhatWasMeasuredOrALittleMore) {
    const auto& [width, method, fine, peak, peak_of_point] = GetParam();
    BakePlan plan = fine ? plan_of(method, 512, 9, RoughnessCurve::Kind::filament)
                         : plan_of(method, 256, 7, RoughnessCurve::Kind::linear);
    plan.filter.samples = method == "auto" ? 1024 : 32;
    constexpr double shared = memory_of_shared_tables / mib;
    EXPECT_GE(mib_of(width, plan), peak);
    EXPECT_GE(mib_of(width, plan) + shared, peak_of_point);
    EXPECT_LE(mib_of(width, plan), 1.8 * std::max(peak, peak_of_point));
}

// Above 1024 rows only what is streamed stays small; lobes out of the transform's reach need texels.
TEST(MemoryOfBakes, FollowsWhatIsKept) {
    const auto linear = RoughnessCurve::Kind::linear;
    const double streamed = mib_of(16384, plan_of("auto", 256, 7, linear));
    const double texels = 16384.0 * 8192 * 28 / mib;
    EXPECT_LT(streamed, 0.1 * texels);
    EXPECT_GT(mib_of(16384, plan_of("reference", 256, 7, linear)), texels);
    BakePlan narrow = plan_of("auto", 256, 3, RoughnessCurve::Kind::list);
    narrow.specular.roughness.list = {0, 0.02, 1};
    EXPECT_GT(mib_of(16384, narrow), texels);
}

TEST(MemoryOfBakes, GrowsWithWhatIsAsked) {
    const BakePlan plan;
    const double before = mib_of(1024, plan);
    BakePlan more = plan;
    more.filter.accuracy = 1e-5;
    EXPECT_GT(mib_of(1024, more), before);
    more = plan;
    more.probes = 2000;
    EXPECT_GT(mib_of(1024, more), before + 2000 * 0.2);
    more = plan;
    more.specular.face_size = 2048;
    EXPECT_GT(mib_of(1024, more), before + 6 * 2048 * 2048 * 20 / mib);
    more = plan;
    more.filter.method = "importance";
    more.filter.samples = 1 << 24;
    EXPECT_GT(mib_of(1024, more), 7 * 20 * 16);
    EXPECT_GT(mib_of(1024, plan, 64), before);
    EXPECT_GT(memory_of_bake({1024, 512, int64_t{1} << 30}, plan, 4), int64_t{1} << 30);
}

// The transform reaches as far as the lobes ask for under a point light: the bound knows it by a
// formula of its own.
TEST(MemoryOfBakes, CoversTheTransform) {
    FilterTables tables;
    for (const double accuracy : {1e-2, 1e-3, 3e-4, 1e-4})
        for (const double roughness : {0.07, 0.1, 0.2, 0.4}) {
            BakePlan plan = plan_of("spectral", 16, 2, RoughnessCurve::Kind::list);
            plan.specular.roughness.list = {0, roughness};
            plan.filter.accuracy = accuracy;
            const Lobe lobe{LobeKind::ggx, roughness * roughness};
            const auto bands = bands_to_transform(tables, {&lobe, 1}, accuracy);
            ASSERT_TRUE(bands);
            const double transform = 24.0 * *bands * *bands + 24.0 * *bands * 512;
            EXPECT_GE(mib_of(1024, plan), 16 * 1024 * 512 / mib + transform / mib)
                << accuracy << " " << roughness;
        }
}

}  // namespace
}  // namespace splitsum
