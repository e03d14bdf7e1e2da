#include "splitsum/bake/light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "splitsum/filter/irradiance_harmonics.h"
#include "splitsum/filter/spectral.h"
#include "splitsum/measure/error_figures.h"
#include "support/lopsided_sky.h"
#include "support/temporary_folder.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

constexpr int rows = 1152;  // just enough to be streamed

// A Portable Float Map: a line of text for each of kind, size and byte order, then rows from the
// bottom up.
void write_pfm(const fs::path& path, const Environment& sky, Vec3 first_texel) {
    std::ofstream file(path, std::ios::binary);
    file << "PF\n" << sky.width() << " " << sky.height() << "\n-1.0\n";
    for (int y = sky.height() - 1; y >= 0; --y)
        for (int x = 0; x < sky.width(); ++x) {
            const Vec3 texel = x == 0 && y == 0 ? first_texel : sky.texel(x, y);
            file.write(reinterpret_cast<const char*>(&texel), sizeof texel);
        }
}

LevelsPlan small_plan() {
    LevelsPlan plan;
    plan.specular = SpecularPlan{16, 3, {}};
    plan.irradiance = IrradiancePlan{};
    plan.irradiance->face_size = 8;
    return plan;
}

class StreamedLight : public testing::Test {
protected:
    Result<Light> load(bool keep_texels, const PanoramaOptions& options = {}) {
        NoProgress progress;
        return load_light(path(), options, {small_plan(), keep_texels}, progress);
    }
    fs::path path() const { return folder_.path() / "sky.pfm"; }

    tests::TemporaryFolder folder_;
    Environment sky_ = tests::lopsided_sky(rows, 500);
};

TEST_F(StreamedLight, FiltersLikeLightInMemory) {
    write_pfm(path(), sky_, sky_.texel(0, 0));
    const auto streamed = load(false), kept = load(true);
    ASSERT_TRUE(streamed) << streamed.error().message;
    ASSERT_TRUE(kept);
    ASSERT_TRUE(streamed->spectrum);
    EXPECT_FALSE(kept->spectrum);
    EXPECT_LT(streamed->environment.height(), rows);
    EXPECT_EQ(streamed->source.hash, kept->source.hash);

    NoProgress progress;
    const auto a = filter_levels(streamed->filter_source(), small_plan(), progress);
    const auto b = filter_levels(kept->filter_source(), small_plan(), progress);
    ASSERT_TRUE(a);
    ASSERT_TRUE(b);
    for (size_t level = 1; level < a->specular.size(); ++level)
        EXPECT_LT(error_figures(std::span<const Vec3>(a->specular[level].texels),
                                b->specular[level].texels)
                      .rel_rms,
                  2e-4);
    EXPECT_LT(
        error_figures(std::span<const Vec3>(a->irradiance->texels), b->irradiance->texels).rel_rms,
        2e-4);
    EXPECT_EQ(a->specular[0].texels, b->specular[0].texels);  // the mirror level, bit for bit

    const auto series = irradiance_harmonics(streamed->filter_source(), 2, false, Mat3d(1));
    const auto direct = irradiance_harmonics(kept->filter_source(), 2, false, Mat3d(1));
    for (size_t i = 0; i < series.coefficients.size(); ++i)
        EXPECT_LT(length(series.coefficients[i] - direct.coefficients[i]), 1e-5);
}

TEST_F(StreamedLight, ASunTooStrongForTheGuessIsReadOnceMore) {
    write_pfm(path(), sky_, Vec3(1e8f));
    const auto streamed = load(false), kept = load(true);
    ASSERT_TRUE(streamed) << streamed.error().message;
    ASSERT_TRUE(streamed->spectrum);
    const auto guess = bands_to_transform(*kept->tables, lobes_of(small_plan()), 3e-4);
    EXPECT_GT(streamed->spectrum->bands(), *guess);
    NoProgress progress;
    const auto a = filter_levels(streamed->filter_source(), small_plan(), progress);
    const auto b = filter_levels(kept->filter_source(), small_plan(), progress);
    for (size_t level = 1; level < a->specular.size(); ++level) {
        EXPECT_LT(a->accounts[level].error_bound, 3e-4);
        EXPECT_LT(error_figures(std::span<const Vec3>(a->specular[level].texels),
                                b->specular[level].texels)
                      .rel_rms,
                  2e-4);
    }
}

// The figures of a certificate do not depend on whether the texels could be kept.
TEST_F(StreamedLight, IsMeasuredLikeLightInMemory) {
    write_pfm(path(), sky_, Vec3(1e8f));  // streamed twice
    NoProgress progress;
    const auto streamed = load_light(path(), {}, {.levels = small_plan(), .probes = 3}, progress);
    const auto kept = load(true);
    ASSERT_TRUE(streamed && kept);
    EXPECT_TRUE(kept->exact.empty());
    const auto a = exact_texels(*streamed, small_plan(), {}, progress);
    const auto b = exact_texels(*kept, small_plan(), 3, progress);
    ASSERT_TRUE(a && b);
    ASSERT_EQ(a->size(), 5u);  // three levels, irradiance, harmonics
    for (size_t i = 0; i < 5; ++i) {
        EXPECT_EQ((*a)[i].texels.size(), 3u);
        EXPECT_EQ((*a)[i].texels, (*b)[i].texels);
        EXPECT_EQ((*a)[i].radiance, (*b)[i].radiance) << i;
    }
    const auto read = exact_readings(*streamed, small_plan(), {}, progress);
    const auto read_later = exact_readings(*kept, small_plan(), 3, progress);
    ASSERT_TRUE(read && read_later);
    ASSERT_EQ(read->bands.size(), 4u);
    for (size_t band = 0; band < 4; ++band)
        for (size_t i = 0; i < 3; ++i) {
            EXPECT_GT(read->bands[band].probes[i].exact.x, 0);
            EXPECT_EQ(read->bands[band].probes.at(i).exact,
                      read_later->bands[band].probes.at(i).exact);
        }
}

TEST_F(StreamedLight, RefusesDefectsAsReadingDoes) {
    write_pfm(path(), sky_, Vec3(std::numeric_limits<float>::quiet_NaN()));
    const auto streamed = load(false), kept = load(true);
    ASSERT_FALSE(streamed);
    ASSERT_FALSE(kept);
    EXPECT_EQ(streamed.error().kind, ErrorKind::unusable_input);
    EXPECT_EQ(streamed.error().message, kept.error().message);
}

TEST_F(StreamedLight, RepairsWhatItWasAskedTo) {
    write_pfm(path(), sky_, Vec3(std::numeric_limits<float>::quiet_NaN()));
    PanoramaOptions options;
    options.repair = true;
    const auto streamed = load(false, options);
    ASSERT_TRUE(streamed) << streamed.error().message;
    EXPECT_EQ(streamed->source.repaired_texels, 1);
    const Vec3d mean = mean_radiance(streamed->environment);
    EXPECT_LT(length(mean - mean_radiance(sky_)), 1e-4 * length(mean));
}

}  // namespace
}  // namespace splitsum
