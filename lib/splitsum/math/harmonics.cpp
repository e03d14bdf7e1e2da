#include "splitsum/math/harmonics.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

// sqrt((4 l² - 1) / (l² - m²)): what the fully normalised recurrence multiplies with.
double recurrence_factor(int l, int m) {
    const double l2 = static_cast<double>(l) * l;
    return std::sqrt((4 * l2 - 1) / (l2 - static_cast<double>(m) * m));
}

// The azimuthal factors of +m and -m: sqrt(2) cos(m phi) and sqrt(2) sin(m phi), or 1 and none.
struct Azimuth {
    double cosine;
    double sine;
};

// Writes order m and -m of all bands; `start` is the normalised Legendre function of l = m.
void write_order(int m, int order, double z, double start, const Azimuth& azimuth,
                 std::span<double> values) {
    double before = 0;
    double current = start;
    double previous_factor = 1;
    for (int l = m;; ++l) {
        if (m > 0) values[harmonic_index(l, -m)] = current * azimuth.sine;
        values[harmonic_index(l, m)] = current * azimuth.cosine;
        if (l == order) return;
        const double factor = recurrence_factor(l + 1, m);
        const double next = factor * (z * current - before / previous_factor);
        before = current;
        current = next;
        previous_factor = factor;
    }
}

}  // namespace

void evaluate_harmonics(const Vec3d& direction, int order, std::span<double> values) {
    assert(values.size() >= harmonic_count(order));
    const double sine = std::hypot(direction.x, direction.y);
    // At the poles every m > 0 vanishes, so any azimuth will do.
    const double cos_phi = sine > 0 ? direction.x / sine : 1;
    const double sin_phi = sine > 0 ? direction.y / sine : 0;

    double start = 0.5 * std::numbers::inv_sqrtpi;
    write_order(0, order, direction.z, start, {1, 0}, values);
    Azimuth azimuth{std::numbers::sqrt2, 0};
    for (int m = 1; m <= order; ++m) {
        azimuth = {azimuth.cosine * cos_phi - azimuth.sine * sin_phi,
                   azimuth.sine * cos_phi + azimuth.cosine * sin_phi};
        start *= sine * std::sqrt((2.0 * m + 1) / (2.0 * m));
        write_order(m, order, direction.z, start, azimuth, values);
    }
}

}  // namespace splitsum
