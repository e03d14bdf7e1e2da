#include "splitsum/filter/gaussians.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "splitsum/filter/irradiance_harmonics.h"
#include "splitsum/filter/methods.h"
#include "splitsum/math/quadrature.h"
#include "splitsum/measure/error_figures.h"
#include "splitsum/sphere/orientation.h"
#include "support/skies.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

// E / pi of a lobe by rings about its axis: within a ring the clamped cosine has a closed form.
double irradiance_by_rings(double sharpness, double cosine) {
    static const QuadratureRule rule = gauss_legendre(200);
    const double sine = std::sqrt(1 - cosine * cosine);
    const auto ring = [&](double theta) {
        const double along = cosine * std::cos(theta), across = sine * std::sin(theta);
        const double weight = std::sin(theta) * std::exp(sharpness * (std::cos(theta) - 1));
        if (along >= across) return weight * 2 * pi * along;
        if (along <= -across) return 0.0;
        const double reach = std::acos(-along / across);
        return weight * 2 * (along * reach + across * std::sin(reach));
    };
    double sum = 0;
    for (int panel = 0; panel < 8; ++panel)
        sum += integrate(rule, pi * panel / 8, pi * (panel + 1) / 8, ring);
    return sum / pi;
}

// Measured: 1.1 % at sharpness 5, 0.35 % at 64. The published constant, 0.36, has 1.9 %.
TEST(GaussianIrradiance, IsWithinItsStatedError) {
    for (const double sharpness : {1.0, 1.5, 2.0, 3.6, 5.0, 8.0, 14.4, 30.0, 64.0})
        for (int i = 0; i <= 80; ++i) {
            const double cosine = -1 + i / 40.0;
            const double peak = irradiance_by_rings(sharpness, 1);
            ASSERT_NEAR(gaussian_irradiance_over_pi(sharpness, cosine),
                        irradiance_by_rings(sharpness, cosine), 0.012 * peak)
                << sharpness << ", " << cosine;
        }
}

TEST(GaussianIrradiance, IsExactAlongItsAxis) {
    for (const double sharpness : {1.0, 3.6, 8.0, 14.4}) {
        const double front = irradiance_by_rings(sharpness, 1);
        EXPECT_NEAR(gaussian_irradiance_over_pi(sharpness, 1) / front, 1, 1e-9);
        const double back = irradiance_by_rings(sharpness, -1);
        EXPECT_NEAR(gaussian_irradiance_over_pi(sharpness, -1) / back, 1, 1e-6);
    }
}

std::vector<Vec3d> even_normals(int count) {
    std::vector<Vec3d> normals;
    for (int i = 0; i < count; ++i)
        normals.push_back(direction_of_lat_long(std::fmod(0.137 + 0.618034 * i, 1.0),
                                                std::acos(1 - (2 * i + 1.0) / count) / pi));
    return normals;
}

std::vector<Vec3> exact_irradiance(const Environment& sky, const std::vector<Vec3d>& normals) {
    const Lobe cosine{LobeKind::cosine};
    const auto filter =
        find_filter_method("reference", LobeKind::cosine)->prepare(sky, {&cosine, 1}, {});
    std::vector<Vec3> result(normals.size());
    filter->evaluate(0, {normals, 0}, result);
    return result;
}

ErrorFigures figures_of(const SphericalGaussians& gaussians, const std::vector<Vec3d>& normals,
                        const std::vector<Vec3>& exact) {
    std::vector<Vec3> read;
    for (const Vec3d& n : normals) read.push_back(Vec3(irradiance_over_pi(gaussians, n)));
    return error_figures(read, exact);
}

struct Limits {
    std::string_view sky;
    double few, some, many;  // rel_rms with 6, 12 and 24 lobes
};

// Measured 0.035, 0.0050, 0.0018; 0.078, 0.018, 0.012; 0.22, 0.14, 0.065; 0.17, 0.015, 0.0041.
constexpr Limits limits[] = {{"overcast", 0.05, 0.0075, 0.0027},
                             {"lopsided", 0.12, 0.027, 0.018},
                             {"studio", 0.33, 0.21, 0.1},
                             {"sunset", 0.26, 0.023, 0.0065}};

TEST(SphericalGaussians, ComeAsCloseAsTheyAreSaidTo) {
    const std::vector<Vec3d> normals = even_normals(200);
    for (size_t i = 0; i < tests::skies().size(); ++i) {
        const tests::NamedSky& named = tests::skies()[i];
        ASSERT_EQ(named.name, limits[i].sky);
        const Environment sky = named.make(64);
        const std::vector<Vec3> exact = exact_irradiance(sky, normals);
        const auto error = [&](int count) {
            return figures_of(fit_gaussians(sky, count), normals, exact).rel_rms;
        };
        EXPECT_LT(error(6), limits[i].few) << named.name;
        EXPECT_LT(error(12), limits[i].some) << named.name;
        EXPECT_LT(error(24), limits[i].many) << named.name;
    }
}

// Unlike harmonics: a sun pushes those of order 2 below zero.
TEST(SphericalGaussians, AreNeverNegative) {
    Environment sun(64);
    sun.set_texel(40, 20, Vec3(1e6f, 5e5f, 0));
    ASSERT_LT(irradiance_harmonics(sun, 2, false, Mat3d(1)).lowest, -0.01);
    for (int count = fewest_gaussians; count <= most_gaussians; ++count) {
        const SphericalGaussians gaussians = fit_gaussians(sun, count);
        ASSERT_EQ(gaussians.axes.size(), size_t(count));
        for (const Vec3d& amplitude : gaussians.amplitudes)
            for (int c = 0; c < 3; ++c) ASSERT_GE(amplitude[c], 0);
        for (const Vec3d& n : even_normals(100))
            for (int c = 0; c < 3; ++c) ASSERT_GE(irradiance_over_pi(gaussians, n)[c], 0);
    }
}

// A least-squares fit: no other amplitudes are closer. A single lobe's, 1 % up or down, would be.
TEST(SphericalGaussians, AreTheBestOfTheirKind) {
    const Environment sky = tests::lopsided_sky(64);
    const std::vector<Vec3d> normals = even_normals(2000);
    const std::vector<Vec3> exact = exact_irradiance(sky, normals);
    SphericalGaussians gaussians = fit_gaussians(sky, 12);
    const double best = figures_of(gaussians, normals, exact).rel_rms;
    for (Vec3d& amplitude : gaussians.amplitudes)
        for (int c = 0; c < 3; ++c)
            for (const double factor : {0.9, 1.1}) {
                const double kept = amplitude[c];
                if (kept == 0) continue;
                amplitude[c] *= factor;
                EXPECT_GT(figures_of(gaussians, normals, exact).rel_rms, best);
                amplitude[c] = kept;
            }
}

// Fitted in turned axes and read along turned normals, the light is the same, but for the lattice
// that lies elsewhere.
TEST(SphericalGaussians, LieInTheAxesOfTheCube) {
    const Environment sky = tests::lopsided_sky(64);
    Orientation orientation;
    orientation.rotate_degrees = 70;
    orientation.mirror = true;
    const Mat3d to_panorama = panorama_from_cube(orientation);
    const SphericalGaussians gaussians = fit_gaussians(sky, 24, to_panorama);
    const std::vector<Vec3d> normals = even_normals(100);
    std::vector<Vec3d> turned;
    for (const Vec3d& n : normals) turned.push_back(to_panorama * n);
    EXPECT_LT(figures_of(gaussians, normals, exact_irradiance(sky, turned)).rel_rms, 0.018);
    EXPECT_GT(figures_of(gaussians, normals, exact_irradiance(sky, normals)).rel_rms, 0.2);
}

TEST(SphericalGaussians, OfDarknessAreDark) {
    const SphericalGaussians gaussians = fit_gaussians(Environment(4), 8);
    EXPECT_EQ(irradiance_over_pi(gaussians, {0, 1, 0}), Vec3d(0));
}

}  // namespace
}  // namespace splitsum
