#include "splitsum/verify/exact_probes.h"

#include <gtest/gtest.h>

#include "splitsum/base/parallel.h"
#include "splitsum/filter/reference.h"
#include "splitsum/sphere/orientation.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

const std::vector<ProbedCubemap> cubemaps = {{{LobeKind::ggx, 0}, 16},
                                             {{LobeKind::ggx, 0.09}, 8},
                                             {{LobeKind::ggx, 1}, 1},
                                             {{LobeKind::cosine}, 5}};

class ExactProbesOfASky : public testing::Test {
protected:
    std::vector<ExactTexels> in_bands_of(int rows, int floats_per_texel) const {
        std::vector<float> texels;
        for (size_t i = 0; i < sky_.texels().size(); ++i)
            if (int(i % 4) < floats_per_texel) texels.push_back(sky_.texels()[i]);
        ExactProbes exact(sky_.height(), turn_, cubemaps, 9);
        const size_t row = size_t(floats_per_texel) * size_t(sky_.width());
        for (int y = 0; y < sky_.height(); y += rows)
            exact.add_rows(std::min(rows, sky_.height() - y), texels.data() + row * size_t(y),
                           floats_per_texel);
        return std::move(exact).finish();
    }

    Environment sky_ = tests::lopsided_sky(48, 200);
    Mat3d turn_ = panorama_from_cube({40, true, "khronos-sampler"});
};

TEST_F(ExactProbesOfASky, AreTheSameForRowsInBandsAndForAnyThreads) {
    NoProgress progress;
    const auto kept = exact_texels(sky_, turn_, cubemaps, 9, progress);
    ASSERT_TRUE(kept);
    for (const int rows : {1, 7, 48})
        for (const int floats : {3, 4}) {
            const ThreadLimit limit(rows == 7 ? 1 : 4);
            const auto streamed = in_bands_of(rows, floats);
            ASSERT_EQ(streamed.size(), cubemaps.size());
            for (size_t i = 0; i < cubemaps.size(); ++i) {
                EXPECT_EQ(streamed[i].face_size, cubemaps[i].face_size);
                EXPECT_EQ(streamed[i].texels, (*kept)[i].texels);
                EXPECT_EQ(streamed[i].radiance, (*kept)[i].radiance) << i;
            }
        }
}

TEST_F(ExactProbesOfASky, AreWhatReferenceSaysOfTheTexels) {
    const auto exact = in_bands_of(16, 4);
    for (size_t i = 1; i < cubemaps.size(); ++i) {
        const auto reference = prepare_reference(sky_, {&cubemaps[i].lobe, 1}, {});
        for (size_t k = 0; k < exact[i].texels.size(); ++k) {
            const auto [face, x, y] = exact[i].texels[k];
            const Vec3d towards = turn_ * direction_of_texel(face, x, y, cubemaps[i].face_size);
            Vec3 radiance;
            reference->evaluate(0, {{&towards, 1}}, {&radiance, 1});
            EXPECT_EQ(exact[i].radiance[k], radiance);
        }
    }
}

// Every texel of a cube together is the sphere: the means, weighted by solid angle, give the sky's.
TEST(TexelMeans, OfAllTexelsAddUpToTheSky) {
    const Environment sky = tests::lopsided_sky(48, 200);
    const ProbedCubemap mirror{{LobeKind::ggx, 0}, 6};
    NoProgress progress;
    const auto exact =
        exact_texels(sky, panorama_from_cube({10, false, "ktx"}), {&mirror, 1}, 1000, progress);
    Vec3d sum(0);
    for (size_t i = 0; i < exact->front().texels.size(); ++i) {
        const auto [face, x, y] = exact->front().texels[i];
        sum += solid_angle_of_texel(x, y, 6) * Vec3d(exact->front().radiance[i]);
    }
    const Vec3d mean = mean_radiance(sky);
    EXPECT_LT(length(sum / (4 * 3.141592653589793) - mean), 2e-3 * length(mean));
}

class Cancelled final : public Progress {
public:
    void begin(std::string_view, int) override {}
    void advance(int) override {}
    bool cancelled() const override { return true; }
};

TEST_F(ExactProbesOfASky, StopWhenCancelled) {
    Cancelled progress;
    const auto exact = exact_texels(sky_, turn_, cubemaps, 9, progress);
    ASSERT_FALSE(exact);
    EXPECT_EQ(exact.error().kind, ErrorKind::interrupted);
}

}  // namespace
}  // namespace splitsum
