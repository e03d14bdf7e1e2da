#include "splitsum/filter/reference_probes.h"

#include <gtest/gtest.h>

#include "splitsum/filter/reference.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

const std::vector<Lobe> lobes = {{LobeKind::ggx, 1e-3},
                                 {LobeKind::ggx, 0.02},
                                 {LobeKind::ggx, 0.3},
                                 {LobeKind::ggx, 1},
                                 {LobeKind::cosine}};

// At the poles, on the seam and anywhere.
const std::vector<Vec3d> directions = {{0, 1, 0},
                                       {0, -1, 0},
                                       {0, 0, -1},
                                       normalize(Vec3d(1, 2, -3)),
                                       normalize(Vec3d(-0.3, 0.1, 0.2))};

std::vector<ReferenceProbes::Probe> every_probe() {
    std::vector<ReferenceProbes::Probe> probes;
    for (const Lobe& lobe : lobes)
        for (const Vec3d& direction : directions) probes.push_back({lobe, direction});
    return probes;
}

std::vector<Vec3> kept(const Environment& sky) {
    const auto filter = prepare_reference(sky, lobes, {});
    std::vector<Vec3> radiance(lobes.size() * directions.size());
    for (size_t i = 0; i < lobes.size(); ++i)
        filter->evaluate(i, {directions},
                         std::span(radiance).subspan(i * directions.size(), directions.size()));
    return radiance;
}

// Bit for bit: what a file was certified with can be measured again where all texels are at hand.
TEST(ReferenceProbes, EqualReferenceForRowsInBandsOfAnySize) {
    for (const int height : {1, 17, 64}) {
        const Environment sky = tests::lopsided_sky(height, 300);
        const size_t width = size_t(sky.width());
        std::vector<float> rgb;
        for (size_t i = 0; i < sky.texels().size(); ++i)
            if (i % 4 < 3) rgb.push_back(sky.texels()[i]);
        for (const int band : {1, 5, 64}) {
            ReferenceProbes of3(height, every_probe()), of4(height, every_probe());
            for (int y = 0; y < height; y += band) {
                const int rows = std::min(band, height - y);
                of3.add_rows(rows, rgb.data() + 3 * width * size_t(y), 3);
                of4.add_rows(rows, sky.texels().data() + 4 * width * size_t(y), 4);
            }
            EXPECT_EQ(of3.finish(), kept(sky)) << height << " rows, " << band << " at a time";
            EXPECT_EQ(of4.finish(), kept(sky)) << height << " rows, " << band << " at a time";
        }
    }
}

}  // namespace
}  // namespace splitsum
