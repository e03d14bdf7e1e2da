#include "splitsum/preview/truth_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "splitsum/base/parallel.h"
#include "splitsum/sphere/orientation.h"
#include "support/skies.h"

namespace splitsum {
namespace {

Scene small_scene() {
    Scene scene;
    const Vec3d gold(1, 0.78, 0.34);
    scene.spheres = {{"rough metal", Vec3d(-1, 0, 0), 0.45, {gold, 1, 0.7}},
                     {"glossy dielectric", Vec3d(0, 0.2, 0.3), 0.45, {gold, 0, 0.3}},
                     {"mirror", Vec3d(1, 0, 0), 0.3, {gold, 1, 0}}};
    return scene;
}

TruthPicture draw(const Environment& sky, const TruthPlan& plan, Progress& progress,
                  int width = 48) {
    const Scene scene = small_scene();
    const Camera camera =
        camera_for(scene, {.width = width, .height = width / 2, .yaw_degrees = 160});
    return truth_picture(scene, camera, sky, panorama_from_cube({.rotate_degrees = 25}), plan,
                         progress);
}

TruthPicture draw(const Environment& sky, const TruthPlan& plan) {
    NoProgress progress;
    return draw(sky, plan, progress);
}

// Counts what it is told, and may say stop after so many questions.
class Watcher final : public Progress {
public:
    explicit Watcher(int64_t questions = -1) : left_(questions) {}
    void begin(std::string_view, int steps) override { steps_ = steps; }
    void advance(int steps) override { done_ += steps; }
    bool cancelled() const override { return left_ >= 0 && --left_ < 0; }
    int steps() const { return steps_; }
    int done() const { return done_; }

private:
    int steps_ = 0;
    std::atomic<int> done_ = 0;
    mutable std::atomic<int64_t> left_;
};

TEST(TruthPicture, ReachesTheNoiseThatIsAskedFor) {
    const Environment sky = tests::studio_sky(64);
    int64_t samples = 0;
    for (const double noise : {0.05, 0.01}) {
        Watcher progress;
        const TruthPicture picture = draw(sky, {.noise = noise}, progress);
        EXPECT_LE(picture.noise, noise);
        EXPECT_GT(picture.noise, 0);
        EXPECT_EQ(picture.end, TruthEnd::noise_reached);
        EXPECT_GT(picture.total_samples, 2 * samples);
        samples = picture.total_samples;
        EXPECT_EQ(progress.done(), progress.steps());
    }
}

// Another seed differs by what both state: the mean of the squared difference in standard errors is
// 1, or 7/5 because the variance of 8 replicates is an estimate itself (Student's t).
TEST(TruthPicture, StatesItsStandardErrorHonestly) {
    const Environment sky = tests::studio_sky(64);
    const TruthPicture one = draw(sky, {.noise = 0.01, .seed = 1});
    const TruthPicture good = draw(sky, {.noise = 0.0015, .seed = 2});
    double sum = 0, stated = 0, actual = 0;
    int count = 0;
    for (size_t i = 0; i < one.mean.size(); ++i) {
        if (one.samples[i] == 0) continue;
        const double error2 =
            std::pow(one.standard_error[i].y, 2) + std::pow(good.standard_error[i].y, 2);
        const double miss2 = std::pow(one.mean[i].y - good.mean[i].y, 2);
        sum += miss2 / error2, stated += error2, actual += miss2;
        ++count;
    }
    ASSERT_GT(count, 200);
    EXPECT_NEAR(sum / count, 1.3, 0.35);
    EXPECT_NEAR(actual / stated, 1, 0.35);
}

// Where all channels are alike, luminance is any of them, and so is its standard error; the root of
// a variance of 8 values is 0.965 of what it should be.
TEST(TruthPicture, StatesTheMeanOfRelativeErrors) {
    const Environment sky = tests::environment_of(
        32, [](const Vec3d& d) { return Vec3(d.x > 0.6 ? 20.0f + float(d.z) : 0.001f); });
    Scene scene = small_scene();
    for (Sphere& sphere : scene.spheres) sphere.material.base_color = Vec3d(0.5);
    const Camera camera = camera_for(scene, {.width = 48, .height = 24});
    NoProgress progress;
    const TruthPicture picture =
        truth_picture(scene, camera, sky, panorama_from_cube({}), {.noise = 0.02}, progress);
    double luminance = 0, pixels = 0, noise = 0, sampled = 0;
    for (size_t i = 0; i < picture.mean.size(); ++i)
        if (picture.sphere_at[i] != TruthPicture::background)
            luminance += double(picture.mean[i].y), ++pixels;
    int dark = 0;
    for (size_t i = 0; i < picture.mean.size(); ++i)
        if (picture.samples[i] > 0) {
            const double least = 0.01 * luminance / pixels;
            dark += double(picture.mean[i].y) < least;
            noise +=
                double(picture.standard_error[i].y) / std::max(double(picture.mean[i].y), least);
            ++sampled;
        }
    EXPECT_GT(dark, 0);
    EXPECT_NEAR(picture.noise / (noise / sampled), 1 / 0.96503, 1e-4);
}

TEST(TruthPicture, KnowsWhatIsExact) {
    const Environment sky = tests::studio_sky(64);
    const TruthPicture picture = draw(sky, {.noise = 0.05});
    int exact = 0, background = 0;
    for (size_t i = 0; i < picture.mean.size(); ++i) {
        const bool sampled = picture.sphere_at[i] == 0 || picture.sphere_at[i] == 1;
        EXPECT_EQ(picture.samples[i] > 0, sampled);
        EXPECT_EQ(picture.standard_error[i].x > 0, sampled);
        background += picture.sphere_at[i] == TruthPicture::background;
        exact += picture.sphere_at[i] == 2;
        EXPECT_EQ(picture.mean[i].x > 0, picture.sphere_at[i] != TruthPicture::background);
    }
    EXPECT_GT(exact, 20);
    EXPECT_GT(background, 200);
}

TEST(TruthPicture, IsDoneAtOnceUnderUniformLight) {
    const Environment grey = tests::environment_of(8, [](const Vec3d&) { return Vec3(0.5f); });
    Watcher progress;
    const TruthPicture picture = draw(grey, {.noise = 1e-9}, progress);
    EXPECT_EQ(picture.noise, 0);
    EXPECT_EQ(picture.total_samples, 0);
    EXPECT_EQ(picture.end, TruthEnd::noise_reached);
    EXPECT_EQ(progress.done(), progress.steps());
    for (size_t i = 0; i < picture.mean.size(); ++i) EXPECT_LE(picture.mean[i].x, 0.5f + 1e-6f);
}

TEST(TruthPicture, DoesNotDependOnThreads) {
    const Environment sky = tests::lopsided_sky(32, 1000);
    const auto with = [&](int threads) {
        const ThreadLimit limit(threads);
        return draw(sky, {.noise = 0.01, .seed = 3});
    };
    const TruthPicture one = with(1), many = with(7);
    EXPECT_EQ(one.mean, many.mean);
    EXPECT_EQ(one.standard_error, many.standard_error);
    EXPECT_EQ(one.samples, many.samples);
    EXPECT_EQ(one.noise, many.noise);
    EXPECT_EQ(one.passes, many.passes);
}

TEST(TruthPicture, SpendsSamplesWhereTheNoiseIs) {
    const TruthPicture picture = draw(tests::studio_sky(64), {.noise = 0.004});
    const auto [least, most] = std::ranges::minmax(picture.samples);
    EXPECT_EQ(least, 0);
    std::vector<int64_t> drawn;
    for (const int64_t samples : picture.samples)
        if (samples > 0) drawn.push_back(samples);
    EXPECT_GE(most, 4 * std::ranges::min(drawn));
}

TEST(TruthPicture, KeepsWhatThereIsWhenCancelled) {
    const Environment sky = tests::studio_sky(64);
    Watcher later(2000);
    const TruthPicture picture = draw(sky, {.noise = 1e-4}, later);
    EXPECT_EQ(picture.end, TruthEnd::cancelled);
    EXPECT_GT(picture.passes, 0);
    EXPECT_TRUE(std::isfinite(picture.noise));
    EXPECT_LT(later.done(), later.steps());
    for (size_t i = 0; i < picture.mean.size(); ++i)
        EXPECT_EQ(picture.mean[i].x > 0, picture.sphere_at[i] != TruthPicture::background);
}

TEST(TruthPicture, SaysWhatIsMissingWhenCancelledInTheFirstPass) {
    const Environment sky = tests::studio_sky(64);
    Watcher soon(100);
    const TruthPicture picture = draw(sky, {.noise = 1e-4}, soon);
    EXPECT_EQ(picture.end, TruthEnd::cancelled);
    EXPECT_EQ(picture.passes, 0);
    EXPECT_TRUE(std::isinf(picture.noise));
    int missing = 0, drawn = 0, exact = 0;
    for (size_t i = 0; i < picture.mean.size(); ++i) {
        drawn += picture.samples[i] > 0;
        const bool is_missing = std::isinf(picture.standard_error[i].x);
        missing += is_missing;
        exact += picture.sphere_at[i] == 2 && picture.standard_error[i].x == 0;
        EXPECT_TRUE(!is_missing || picture.mean[i] == Vec3(0));
    }
    EXPECT_EQ(drawn, 100);
    EXPECT_GT(missing, 100);
    EXPECT_GT(exact, 20);
}

TEST(TruthPicture, StopsWhenTimeIsUp) {
    const TruthPicture picture = draw(tests::studio_sky(64), {.noise = 1e-5, .seconds = 0.2});
    EXPECT_EQ(picture.end, TruthEnd::out_of_time);
}

}  // namespace
}  // namespace splitsum
