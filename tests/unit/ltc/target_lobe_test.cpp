#include "splitsum/ltc/target_lobe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

constexpr LtcTarget targets[] = {LtcTarget::ggx, LtcTarget::disney_diffuse};
constexpr double views[] = {0.05, 0.3, 0.8, 1.0};

// The kink where reflections sink below the horizon costs Gauss's rule this much.
constexpr double nodes_accuracy = 2e-3;

// Over all directions, by coordinates that know nothing of the lobe.
template <class Function>
double over_the_sky(const Function& f) {
    const QuadratureRule rule = gauss_legendre(160);
    return integrate(rule, 0, 0.5 * std::numbers::pi, [&](double theta) {
        return integrate(rule, 0, 2 * std::numbers::pi, [&](double phi) {
            return std::sin(theta) * f(Vec3d(std::sin(theta) * std::cos(phi),
                                             std::sin(theta) * std::sin(phi), std::cos(theta)));
        });
    });
}

TEST(TargetLobe, DensitiesIntegrateToOne) {
    for (const LtcTarget target : targets)
        for (const double n_dot_v : views)
            for (const double r : {0.6, 1.0}) {
                const TargetLobe lobe(target, n_dot_v, r);
                EXPECT_NEAR(over_the_sky([&](const Vec3d& l) { return lobe.density(l); }), 1,
                            nodes_accuracy)
                    << int(target) << " " << n_dot_v << " " << r;
            }
}

TEST(TargetLobe, LeansAwayFromTheViewAndEndsAtTheHorizon) {
    const TargetLobe lobe(LtcTarget::ggx, 0.6, 0.3);
    EXPECT_GT(lobe.density({-0.8, 0, 0.6}), 100 * lobe.density({0.8, 0, 0.6}));
    for (const LtcTarget target : targets) {
        const TargetLobe any(target, 0.6, 0.3);
        EXPECT_EQ(any.density({-0.8, 0, -0.6}), 0);
        EXPECT_EQ(any.sampling_pdf({-0.8, 0, -0.6}), 0);
    }
}

// A function that nothing is symmetric to but y -> -y: by the lobe's nodes and by the sky's.
TEST(TargetLobe, NodesIntegrateOverTheLobe) {
    for (const LtcTarget target : targets)
        for (const double n_dot_v : views) {
            const TargetLobe lobe(target, n_dot_v, 0.6);
            const auto f = [&](const Vec3d& l) {
                return lobe.density(l) * (1 + l.x + 0.3 * l.z * l.x + l.y * l.y);
            };
            double sum = 0;
            for (const LobeNode& node : lobe.nodes(40)) sum += 2 * node.weight * f(node.light);
            EXPECT_NEAR(sum, over_the_sky(f), nodes_accuracy) << int(target) << " " << n_dot_v;
        }
}

TEST(TargetLobe, OfMirrorsAndGrazingViewsAreFinite) {
    for (const LtcTarget target : targets)
        for (const double n_dot_v : {0.0, 1e-4, 1.0})
            for (const double r : {0.0, 1e-3, 1.0}) {
                const TargetLobe lobe(target, n_dot_v, r);
                for (const LobeNode& node : lobe.nodes(8)) {
                    EXPECT_TRUE(std::isfinite(lobe.density(node.light)));
                    EXPECT_TRUE(std::isfinite(node.weight));
                }
            }
}

}  // namespace
}  // namespace splitsum
