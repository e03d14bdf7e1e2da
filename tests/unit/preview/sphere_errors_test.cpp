#include "splitsum/preview/sphere_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "baked_skies.h"
#include "splitsum/base/random.h"
#include "splitsum/preview/picture.h"
#include "splitsum/preview/split_exact.h"
#include "splitsum/sphere/orientation.h"
#include "support/skies.h"

namespace splitsum {
namespace {

// A truth of two spheres, 2000 pixels each, and an image of the same.
struct Planted {
    TruthPicture truth;
    Image image{100, 40};
};

Planted planted() {
    Planted result;
    TruthPicture& truth = result.truth;
    truth.width = 100, truth.height = 40;
    for (uint32_t i = 0; i < 4000; ++i) {
        truth.sphere_at.push_back(i < 2000 ? 0 : 1);
        truth.mean.emplace_back(1 + unit_float(i), 2 * unit_float(i + 7000), 0.5f);
        truth.standard_error.emplace_back(0);
        std::copy_n(&truth.mean[i].x, 3, &result.image.rgb[3 * i]);
    }
    return result;
}

// Normal, from two uniform numbers (Box & Muller 1958).
float normal_number(uint32_t key) {
    const float radius = std::sqrt(-2 * std::log(1 - unit_float(2 * key)));
    return radius * std::cos(2 * std::numbers::pi_v<float> * unit_float(2 * key + 1));
}

TEST(SphereErrors, OfWhatIsRightAreNothing) {
    const Planted p = planted();
    for (const SphereErrors& errors : sphere_errors(p.image, p.image, p.truth, 2)) {
        EXPECT_EQ(errors.baked_data.rel_rms, 0);
        EXPECT_EQ(errors.approximation.rel_rms, 0);
        EXPECT_EQ(errors.together.rel_rms, 0);
        EXPECT_EQ(errors.together.pixels, 2000);
        EXPECT_EQ(errors.together.noise, 0);
    }
}

TEST(SphereErrors, FindAPlantedPercentWhereItIs) {
    const Planted p = planted();
    Image baked = p.image, exact = p.image;
    for (size_t i = 0; i < 6000; ++i) baked.rgb[i] *= 1.01f;
    for (size_t i = 6000; i < 12000; ++i) exact.rgb[i] *= 0.99f;
    const auto errors = sphere_errors(baked, exact, p.truth, 2);
    EXPECT_NEAR(errors[0].baked_data.rel_rms, 0.01, 1e-6);
    EXPECT_EQ(errors[0].approximation.rel_rms, 0);
    EXPECT_NEAR(errors[0].together.rel_rms, 0.01, 1e-6);
    EXPECT_NEAR(errors[0].together.bias, 0.01, 1e-6);
    EXPECT_NEAR(errors[1].approximation.rel_rms, 0.01, 1e-6);
    EXPECT_NEAR(errors[1].approximation.bias, -0.01, 1e-6);
    EXPECT_NEAR(errors[1].baked_data.rel_rms, 0.01 / 0.99, 1e-6);
    EXPECT_EQ(errors[1].together.rel_rms, 0);
}

// A truth as noisy as a hundredth, and a difference of a half of that.
TEST(SphereErrors, TakeTheNoiseOut) {
    Planted p = planted();
    for (uint32_t i = 0; i < 4000; ++i)
        for (int c = 0; c < 3; ++c) {
            const float error = 0.02f * p.truth.mean[i][c] * unit_float(i + 12345);
            p.truth.standard_error[i][c] = error;
            p.truth.mean[i][c] += error * normal_number(3 * i + uint32_t(c));
        }
    Image off = p.image;
    for (float& value : off.rgb) value *= 1.005f;
    const auto errors = sphere_errors(off, p.image, p.truth, 2);
    for (const SphereErrors& of_sphere : errors) {
        EXPECT_NEAR(of_sphere.approximation.noise, 0.02 / std::sqrt(3.0), 5e-4);
        EXPECT_LT(of_sphere.approximation.rel_rms, 4e-3);  // 0.0115 with the noise in
        EXPECT_NEAR(of_sphere.together.rel_rms, 0.005, 1e-3);
    }
}

TEST(SphereErrors, LeaveOutWhatIsMissing) {
    Planted p = planted();
    Image baked = p.image;
    for (size_t i = 0; i < 500; ++i) {
        p.truth.mean[i] = Vec3(0);
        p.truth.standard_error[i] = Vec3(std::numeric_limits<float>::infinity());
    }
    const auto errors = sphere_errors(baked, p.image, p.truth, 2);
    EXPECT_EQ(errors[0].together.pixels, 1500);
    EXPECT_EQ(errors[0].together.rel_rms, 0);
    EXPECT_EQ(errors[0].baked_data.texels, 2000);
    EXPECT_EQ(errors[1].together.pixels, 2000);
}

TEST(SphereErrors, NeverMakeNothingOfNaN) {
    const Planted p = planted();
    Image baked = p.image;
    baked.rgb[0] = std::numeric_limits<float>::quiet_NaN();
    const auto errors = sphere_errors(baked, p.image, p.truth, 2);
    EXPECT_FALSE(errors[0].together.rel_rms < 1);
    EXPECT_FALSE(errors[0].baked_data.rel_rms < 1);
    EXPECT_EQ(errors[1].together.rel_rms, 0);
}

// From here on with real pictures: rough and smooth, metal and not, under a lopsided sky.
class SphereErrorsOfBakes : public testing::Test {
protected:
    static Scene make_scene() {
        Scene scene;
        const Vec3d iron(0.6, 0.55, 0.4);
        for (const double metalness : {0.0, 1.0})
            for (const double perceptual_roughness : {0.25, 0.5, 1.0})
                scene.spheres.push_back({"",
                                         Vec3d(4 * (perceptual_roughness - 0.5), metalness, 0),
                                         0.4,
                                         {iron, metalness, perceptual_roughness}});
        return scene;
    }

    std::vector<SphereErrors> errors_of(const BakedLight& light) const {
        NoProgress progress;
        const auto picture = baked_picture(scene_, camera_, light, Background::black, progress);
        return sphere_errors(*picture, split_.radiance, truth_, int(scene_.spheres.size()));
    }

    const Scene scene_ = make_scene();
    const Camera camera_ = camera_for(scene_, {.width = 64, .height = 40, .yaw_degrees = 160});
    const Mat3d panorama_from_cube_ = panorama_from_cube({.rotate_degrees = 30});
    const Environment sky_ = tests::lopsided_sky(64);
    const BakedLight light_ = tests::baked(sky_, panorama_from_cube_, 64, 5);
    NoProgress progress_;
    const SplitExact split_ =
        *split_exact(scene_, camera_, sky_, panorama_from_cube_, 0, progress_);
    const TruthPicture truth_ =
        truth_picture(scene_, camera_, sky_, panorama_from_cube_, {.noise = 0.01}, progress_);
};

// The triangle's inequality, with what the truth is divided by instead of the exact split sum.
TEST_F(SphereErrorsOfBakes, AddUp) {
    for (const SphereErrors& errors : errors_of(light_)) {
        const double a = errors.baked_data.rel_rms * (1 + errors.approximation.rel_rms);
        const double b = errors.approximation.rel_rms, c = errors.together.rel_rms;
        EXPECT_LT(errors.baked_data.rel_rms, 0.02);
        EXPECT_LT(errors.approximation.noise, 0.06);
        EXPECT_LE(c, a + b + 1e-3);
        EXPECT_GE(c, std::abs(a - b) - 1e-3);
        EXPECT_EQ(errors.approximation.pixels, errors.baked_data.texels);
    }
}

TEST_F(SphereErrorsOfBakes, TellBakedDataFromTheApproximation) {
    BakedLight swapped = light_, other_table = light_;
    std::swap(swapped.specular[1], swapped.specular[3]);
    for (size_t i = 0; i < other_table.split_sum.values.size(); i += 2)
        other_table.split_sum.values[i] *= 0.7f;
    const auto right = errors_of(light_);
    for (const BakedLight& wrong : {swapped, other_table}) {
        const auto errors = errors_of(wrong);
        bool noticed = false;
        for (size_t i = 0; i < right.size(); ++i) {
            EXPECT_EQ(errors[i].approximation.rel_rms, right[i].approximation.rel_rms);
            noticed |= errors[i].baked_data.rel_rms > right[i].baked_data.rel_rms + 0.03;
        }
        EXPECT_TRUE(noticed);
    }
}

// The lobe of the split sum knows no horizon: with the light behind it a rough metal's rim is too
// bright, and with the light before it, nothing is added.
TEST_F(SphereErrorsOfBakes, SeeLightFromBehindRoughMetals) {
    const Vec3d behind = panorama_from_cube_ * camera_.cube_from_view * Vec3d(0, 0, 1);
    const auto lit_from = [&](const Vec3d& towards) {
        const Environment lamp = tests::environment_of(64, [&](const Vec3d& d) {
            return dot(d, towards) > 0.95 ? Vec3(100, 90, 80) : Vec3(0.1f);
        });
        const auto split = split_exact(scene_, camera_, lamp, panorama_from_cube_, 0, progress_);
        const TruthPicture truth =
            truth_picture(scene_, camera_, lamp, panorama_from_cube_, {.noise = 0.03}, progress_);
        return sphere_errors(split->radiance, split->radiance, truth, int(scene_.spheres.size()));
    };
    const NoisyFigures from_behind = lit_from(behind).back().approximation;
    EXPECT_GT(from_behind.bias, 0.5);
    EXPECT_GT(from_behind.rel_rms, 0.5);
    EXPECT_LT(lit_from(-behind).back().approximation.bias, 0.1);
}

}  // namespace
}  // namespace splitsum
