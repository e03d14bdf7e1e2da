// Every sampler follows the density that is declared beside it, and the test that says so rejects
// one that is 5 % too wide.
#include <gtest/gtest.h>

#include <cmath>

#include "splitsum/brdf/ggx.h"
#include "splitsum/brdf/lambert.h"
#include "splitsum/brdf/visible_normals.h"
#include "support/chi_square.h"

namespace splitsum {
namespace {

using tests::chi_square_fit;
using tests::ChiSquareFit;
using tests::sidak_threshold;

constexpr int sample_count = 200'000;
constexpr uint32_t seed = 1;
constexpr double too_wide = 1.05;

ChiSquareFit fit_ggx(double sampled_alpha, double declared_alpha) {
    return chi_square_fit(
        [=](const Vec2d& u) { return sample_ggx_normal(u, sampled_alpha).normal; },
        [=](const Vec3d& h) { return ggx_normal_pdf(h, declared_alpha); }, sample_count, seed);
}

TEST(GgxSampling, NormalsFollowTheDeclaredDensity) {
    const double alphas[] = {0.1, 0.3, 1.0};
    for (const double alpha : alphas) {
        const ChiSquareFit fit = fit_ggx(alpha, alpha);
        EXPECT_GT(fit.p_value, sidak_threshold(std::size(alphas)))
            << "alpha " << alpha << ", worst " << fit.worst;
        EXPECT_NEAR(fit.pdf_integral, 1, 1e-6);
    }
}

TEST(GgxSampling, TheTestNoticesAWrongWidth) {
    for (const double alpha : {0.1, 0.3, 0.95}) {
        EXPECT_LT(fit_ggx(too_wide * alpha, alpha).p_value, 1e-6) << alpha;
        EXPECT_LT(fit_ggx(alpha / too_wide, alpha).p_value, 1e-6) << alpha;
    }
}

TEST(CosineSampling, DirectionsFollowTheDeclaredDensity) {
    const ChiSquareFit fit = chi_square_fit(
        sample_cosine_direction, [](const Vec3d& d) { return cosine_direction_pdf(d.z); },
        sample_count, seed);
    EXPECT_GT(fit.p_value, sidak_threshold(1)) << fit.worst;
    EXPECT_NEAR(fit.pdf_integral, 1, 1e-6);
}

// Too wide: the tangent of every direction's angle grows by 5 %.
TEST(CosineSampling, TheTestNoticesAWrongWidth) {
    const auto wider = [](const Vec2d& u) {
        const Vec3d d = sample_cosine_direction(u);
        return normalize(Vec3d(too_wide * d.x, too_wide * d.y, d.z));
    };
    const ChiSquareFit fit = chi_square_fit(
        wider, [](const Vec3d& d) { return cosine_direction_pdf(d.z); }, sample_count, seed);
    EXPECT_LT(fit.p_value, 1e-6);
}

// Views from along the normal to grazing, with azimuths that no symmetry of the cells hides.
Vec3d view_at(double cosine, double azimuth) {
    const double sine = std::sqrt(1 - cosine * cosine);
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

const Vec3d views[] = {view_at(1, 0), view_at(0.8, 0.3), view_at(0.3, 2.1), view_at(0.05, -1.2)};

ChiSquareFit fit_visible(const Vec3d& view, double sampled_alpha, double declared_alpha) {
    return chi_square_fit(
        [=](const Vec2d& u) { return sample_visible_normal(view, u, sampled_alpha); },
        [=](const Vec3d& h) { return visible_normal_pdf(view, h, declared_alpha); }, sample_count,
        seed);
}

TEST(VisibleNormalSampling, NormalsFollowTheDeclaredDensity) {
    const double alphas[] = {0.1, 0.3, 1.0};
    for (const Vec3d& view : views)
        for (const double alpha : alphas) {
            const ChiSquareFit fit = fit_visible(view, alpha, alpha);
            EXPECT_GT(fit.p_value, sidak_threshold(std::size(alphas) * std::size(views)))
                << "n.v " << view.z << ", alpha " << alpha << ", worst " << fit.worst;
            EXPECT_NEAR(fit.pdf_integral, 1, 1e-3) << "n.v " << view.z << ", alpha " << alpha;
        }
}

TEST(VisibleNormalSampling, TheTestNoticesAWrongWidth) {
    for (const Vec3d& view : views)
        for (const double alpha : {0.1, 0.3, 0.95})
            EXPECT_LT(fit_visible(view, too_wide * alpha, alpha).p_value, 1e-6)
                << "n.v " << view.z << ", alpha " << alpha;
}

}  // namespace
}  // namespace splitsum
