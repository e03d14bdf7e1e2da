#include "splitsum/filter/filter_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "splitsum/base/parallel.h"
#include "splitsum/brdf/band_factors.h"
#include "splitsum/filter/asset_levels.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

TEST(FilterTables, MakeEveryTableOnce) {
    FilterTables tables;
    const Lobe narrow{LobeKind::ggx, 0.1}, wide{LobeKind::ggx, 0.2}, diffuse{LobeKind::cosine, 0.1};
    for (const Lobe& lobe : {narrow, wide, diffuse})
        for (const int count : {5, 9})
            EXPECT_EQ(*tables.band_factors(lobe, count), band_factors(lobe, count));
    EXPECT_EQ(tables.band_factors(narrow, 5), tables.band_factors(narrow, 5));
    const Mat3d turned = panorama_from_cube({.rotate_degrees = 20});
    const auto geometry = tables.area_geometry(16, 4, Mat3d(1));
    EXPECT_EQ(tables.area_geometry(16, 4, Mat3d(1)), geometry);
    EXPECT_NE(tables.area_geometry(16, 5, Mat3d(1)), geometry);
    EXPECT_NE(tables.area_geometry(18, 4, Mat3d(1)), geometry);
    EXPECT_NE(tables.area_geometry(16, 4, turned), geometry);
}

TEST(FilterTables, ServeManyThreads) {
    FilterTables tables;
    std::vector<FilterTables::Factors> factors(64);
    parallel_rows(int(factors.size()), [&](int i) {
        factors[size_t(i)] = tables.band_factors({LobeKind::ggx, 0.1 * (1 + i % 4)}, 30);
    });
    for (size_t i = 4; i < factors.size(); ++i) EXPECT_EQ(factors[i], factors[i - 4]);
}

TEST(FilterTables, AreMadeOnceWhenManyAskAtTheSameTime) {
    FilterTables tables;
    std::vector<FilterTables::Factors> factors(8);
    std::vector<FilterTables::Geometry> geometries(factors.size());
    std::atomic<int> ready = 0;
    std::vector<std::jthread> threads;
    for (size_t i = 0; i < factors.size(); ++i)
        threads.emplace_back([&, i] {
            ++ready;
            while (ready < int(factors.size())) std::this_thread::yield();
            factors[i] = tables.band_factors({LobeKind::ggx, 0.05}, 200);
            geometries[i] = tables.area_geometry(256, 64, Mat3d(1));
        });
    threads.clear();
    for (size_t i = 1; i < factors.size(); ++i) {
        EXPECT_EQ(factors[i], factors[0]);
        EXPECT_EQ(geometries[i], geometries[0]);
    }
}

// Large geometries live as long as somebody uses them, small ones until four others came.
TEST(FilterTables, KeepSmallGeometriesOnly) {
    FilterTables tables;
    std::weak_ptr<const AreaGeometry> small = tables.area_geometry(16, 4, Mat3d(1));
    auto used = tables.area_geometry(2048, 256, Mat3d(1));
    EXPECT_EQ(tables.area_geometry(2048, 256, Mat3d(1)), used);
    const std::weak_ptr<const AreaGeometry> large = used;
    used = nullptr;
    EXPECT_TRUE(large.expired());
    EXPECT_FALSE(small.expired());
    for (int other = 1; other <= 4; ++other) tables.area_geometry(16, 4 + other, Mat3d(1));
    EXPECT_TRUE(small.expired());
}

// A panorama's assets may not depend on what was baked before it.
TEST(FilterTables, SharingThemChangesNoBit) {
    const Environment sky = tests::lopsided_sky(40, 1e5f), other = tests::lopsided_sky(64, 1e3f);
    LevelsPlan plan;
    plan.specular = SpecularPlan{16, 3, {}};
    NoProgress progress;
    const auto alone = filter_levels(sky, plan, progress);
    const auto shared = std::make_shared<FilterTables>();
    for (const Environment* before : {&other, &sky})
        ASSERT_TRUE(filter_levels(FilterSource(*before, shared), plan, progress));
    const auto after = filter_levels(FilterSource(sky, shared), plan, progress);
    for (size_t level = 0; level < 3; ++level)
        EXPECT_EQ(after->specular[level].texels, alone->specular[level].texels);
}

}  // namespace
}  // namespace splitsum
