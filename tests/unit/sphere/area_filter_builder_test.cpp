#include "splitsum/sphere/area_filter_builder.h"

#include <gtest/gtest.h>

#include <vector>

#include "splitsum/base/parallel.h"
#include "splitsum/sphere/orientation.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

struct Case {
    int height;
    int face_size;
    Orientation orientation;
};

// Heights whose columns are cut into parts and that are not, even and odd, with the seam anywhere.
const std::vector<Case>& cases() {
    static const std::vector<Case> all = {{300, 33, {25, true, "khronos-sampler"}},
                                          {300, 32, {-101, false, "ktx"}},
                                          {301, 16, {0, false, "ktx"}},
                                          {7, 5, {60, false, "cmgen"}}};
    return all;
}

Cubemap streamed(const Environment& sky, std::shared_ptr<const AreaGeometry> geometry, int band) {
    AreaFilterBuilder builder(std::move(geometry));
    for (int y = 0; y < sky.height(); y += band)
        builder.add_rows(std::min(band, sky.height() - y),
                         sky.texels().data() + 4 * size_t(sky.width()) * size_t(y), 4);
    return std::move(builder).finish();
}

std::shared_ptr<const AreaGeometry> geometry_of(const Case& c) {
    return std::make_shared<const AreaGeometry>(c.height, c.face_size,
                                                panorama_from_cube(c.orientation));
}

TEST(AreaFilterBuilder, BandsOfAnySizeGiveTheSameBits) {
    for (const Case& c : cases()) {
        const Environment sky = tests::lopsided_sky(c.height, 1e5f);
        const auto geometry = geometry_of(c);
        const Cubemap whole = streamed(sky, geometry, c.height);
        for (const int band : {1, 7, 64})
            EXPECT_EQ(streamed(sky, geometry, band).texels, whole.texels)
                << c.height << " rows in bands of " << band;
    }
}

TEST(AreaFilterBuilder, AnyNumberOfThreadsGivesTheSameBits) {
    for (const Case& c : cases()) {
        const Environment sky = tests::lopsided_sky(c.height, 1e5f);
        const auto with_threads = [&](int threads) {
            const ThreadLimit limit(threads);
            return streamed(sky, geometry_of(c), 50);
        };
        EXPECT_EQ(with_threads(1).texels, with_threads(4).texels) << c.height << " rows";
    }
}

TEST(AreaFilterBuilder, ThreeAndFourFloatsATexelGiveTheSameBits) {
    for (const Case& c : cases()) {
        const Environment sky = tests::lopsided_sky(c.height, 1e5f);
        std::vector<float> packed;  // ends where its last texel ends: nothing beyond may be read
        for (size_t i = 0; i < sky.texels().size(); ++i)
            if (i % 4 != 3) packed.push_back(sky.texels()[i]);
        packed.shrink_to_fit();
        AreaFilterBuilder builder(geometry_of(c));
        builder.add_rows(c.height, packed.data(), 3);
        EXPECT_EQ(std::move(builder).finish().texels,
                  streamed(sky, geometry_of(c), c.height).texels);
    }
}

// One geometry, two panoramas under way at the same time: neither sees the other.
TEST(AreaFilterBuilder, AGeometryServesManyPanoramas) {
    const Case& c = cases().front();
    const auto geometry = geometry_of(c);
    const Environment bright = tests::lopsided_sky(c.height, 1e5f);
    const Environment dim = tests::lopsided_sky(c.height, 1);
    AreaFilterBuilder first(geometry), second(geometry);
    const size_t row = 4 * size_t(bright.width());
    for (size_t y = 0; y < size_t(c.height); ++y) {
        first.add_rows(1, bright.texels().data() + y * row, 4);
        second.add_rows(1, dim.texels().data() + y * row, 4);
    }
    EXPECT_EQ(std::move(first).finish().texels, streamed(bright, geometry, 64).texels);
    EXPECT_EQ(std::move(second).finish().texels, streamed(dim, geometry, 64).texels);
}

}  // namespace
}  // namespace splitsum
