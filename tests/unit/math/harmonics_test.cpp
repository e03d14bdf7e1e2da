#include "splitsum/math/harmonics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

std::vector<double> harmonics_at(const Vec3d& direction, int order) {
    std::vector<double> values(harmonic_count(order));
    evaluate_harmonics(direction, order, values);
    return values;
}

// Lopsided directions, both poles, and a direction so close to a pole that 1 - z rounds to 0.
std::vector<Vec3d> directions() {
    return {normalize(Vec3d(0.3, -0.7, 0.2)),
            normalize(Vec3d(-0.9, 0.1, -0.4)),
            normalize(Vec3d(1e-9, -2e-9, 1)),
            Vec3d(0, 0, 1),
            Vec3d(0, 0, -1),
            Vec3d(1, 0, 0)};
}

TEST(Harmonics, FirstBandsAreTheirCartesianPolynomials) {
    const Vec3d d = normalize(Vec3d(0.3, -0.7, 0.2));
    const auto y = harmonics_at(d, 2);
    const double band1 = std::sqrt(3 / (4 * std::numbers::pi));
    const double band2 = std::sqrt(15 / (4 * std::numbers::pi));
    const double expected[] = {0.5 / std::sqrt(std::numbers::pi),
                               band1 * d.y,
                               band1 * d.z,
                               band1 * d.x,
                               band2 * d.x * d.y,
                               band2 * d.y * d.z,
                               band2 / (2 * std::sqrt(3.0)) * (3 * d.z * d.z - 1),
                               band2 * d.x * d.z,
                               0.5 * band2 * (d.x * d.x - d.y * d.y)};
    for (size_t i = 0; i < std::size(expected); ++i) EXPECT_NEAR(y[i], expected[i], 1e-15) << i;
}

// P_l at the cosine of two unit vectors. From their difference (or sum, past a right angle) and in
// differences of P: rounding the cosine itself would move P_200 by 200² / 2 ulp.
std::vector<double> legendre_between(const Vec3d& a, const Vec3d& b, int order) {
    const bool opposed = dot(a, b) < 0;
    const Vec3d chord = opposed ? a + b : a - b;
    const double versine = 0.5 * dot(chord, chord);
    std::vector<double> values(static_cast<size_t>(order) + 1);
    double value = 1;
    double difference = 0;
    for (int l = 0; l <= order; ++l) {
        values[static_cast<size_t>(l)] = opposed && l % 2 == 1 ? -value : value;
        difference = (l * difference - (2 * l + 1) * versine * value) / (l + 1);
        value += difference;
    }
    return values;
}

// The addition theorem ties the harmonics of two directions to a Legendre polynomial.
TEST(Harmonics, ObeyTheAdditionTheorem) {
    constexpr int order = 200;
    for (const Vec3d& a : directions())
        for (const Vec3d& b : directions()) {
            const auto at_a = harmonics_at(a, order);
            const auto at_b = harmonics_at(b, order);
            const auto expected = legendre_between(a, b, order);
            for (int l = 0; l <= order; ++l) {
                double sum = 0;
                for (int m = -l; m <= l; ++m)
                    sum += at_a[harmonic_index(l, m)] * at_b[harmonic_index(l, m)];
                const double factor = (2 * l + 1) / (4 * std::numbers::pi);
                EXPECT_NEAR(sum / factor, expected[static_cast<size_t>(l)], 1e-12) << "band " << l;
            }
        }
}

TEST(Harmonics, BandsKeepTheirNormAtHighOrder) {
    constexpr int order = 1500;
    for (const Vec3d& d : directions()) {
        const auto y = harmonics_at(d, order);
        for (const int l : {700, 1200, order}) {
            double sum = 0;
            for (int m = -l; m <= l; ++m) sum += y[harmonic_index(l, m)] * y[harmonic_index(l, m)];
            EXPECT_NEAR(sum * 4 * std::numbers::pi / (2 * l + 1), 1, 1e-9) << "band " << l;
        }
    }
}

TEST(Harmonics, AreOrthonormal) {
    constexpr int order = 6;
    const size_t count = harmonic_count(order);
    const QuadratureRule rule = gauss_legendre(order + 1);
    std::vector<double> gram(count * count, 0.0);
    constexpr int azimuths = 2 * order + 1;
    for (size_t i = 0; i < rule.nodes.size(); ++i)
        for (int j = 0; j < azimuths; ++j) {
            const double z = rule.nodes[i];
            const double sine = std::sqrt(1 - z * z);
            const double phi = 2 * std::numbers::pi * j / azimuths;
            const auto y = harmonics_at({sine * std::cos(phi), sine * std::sin(phi), z}, order);
            const double weight = rule.weights[i] * 2 * std::numbers::pi / azimuths;
            for (size_t p = 0; p < count; ++p)
                for (size_t q = 0; q < count; ++q) gram[p * count + q] += weight * y[p] * y[q];
        }
    for (size_t p = 0; p < count; ++p)
        for (size_t q = 0; q < count; ++q)
            EXPECT_NEAR(gram[p * count + q], p == q ? 1 : 0, 1e-13) << p << ", " << q;
}

}  // namespace
}  // namespace splitsum
