#include "splitsum/filter/harmonics_of_environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/math/harmonics.h"
#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

using Coefficients = std::vector<Vec3d>;

void add(Coefficients& sum, const Coefficients& terms) {
    for (size_t i = 0; i < sum.size(); ++i) sum[i] += terms[i];
}

// The panorama's polar axis is y, that of the harmonics z: turning the axes once around puts the
// panorama's azimuth atan2(x, z) where the harmonics have theirs.
Vec3d pole_up(const Vec3d& d) { return {d.z, d.x, d.y}; }

// Sine and cosine at the left edges of the columns, 2 pi x / width - pi.
struct ColumnEdges {
    std::vector<double> sine;
    std::vector<double> cosine;

    explicit ColumnEdges(int width) {
        for (int x = 0; x < width; ++x) {
            sine.push_back(std::sin(2 * pi * x / width));
            cosine.push_back(std::cos(2 * pi * x / width));
        }
    }
};

// ∫ L cos(m phi) dphi and ∫ L sin(m phi) dphi along one row.
struct RowMoment {
    Vec3d cosine{0};
    Vec3d sine{0};
};

// Exact for texels of constant radiance: differences of sin(m phi) / m between column edges.
RowMoment moment_of_row(const Environment& environment, int y, int m, const ColumnEdges& edges) {
    const int64_t width = environment.width();
    RowMoment moment;
    for (int64_t x = 0; x < width; ++x) {
        const Vec3d radiance(environment.texel(int(x), y));
        const size_t left = size_t(m * x % width), right = size_t(m * (x + 1) % width);
        if (m == 0) {
            moment.cosine += 2 * pi / double(width) * radiance;
            continue;
        }
        const double per_band = (m % 2 == 0 ? 1.0 : -1.0) / m;  // the edges start at -pi
        moment.cosine += per_band * (edges.sine[right] - edges.sine[left]) * radiance;
        moment.sine -= per_band * (edges.cosine[right] - edges.cosine[left]) * radiance;
    }
    return moment;
}

// ∫ Y_lm(theta, 0) sin(theta) dtheta over row y, for m >= 0.
std::vector<double> harmonics_over_row(int y, int height, int order, const QuadratureRule& rule) {
    std::vector<double> sums(harmonic_count(order), 0.0), values(harmonic_count(order));
    const double half = 0.5 * pi / height;
    for (size_t i = 0; i < rule.nodes.size(); ++i) {
        const double theta = (2 * y + 1 + rule.nodes[i]) * half;
        const double weight = rule.weights[i] * half * std::sin(theta);
        evaluate_harmonics({std::sin(theta), 0, std::cos(theta)}, order, values);
        for (size_t k = 0; k < sums.size(); ++k) sums[k] += weight * values[k];
    }
    return sums;
}

void add_row(const Environment& environment, int y, int order, const QuadratureRule& rule,
             const ColumnEdges& edges, Coefficients& sum) {
    const std::vector<double> over_row = harmonics_over_row(y, environment.height(), order, rule);
    for (int m = 0; m <= order; ++m) {
        const RowMoment moment = moment_of_row(environment, y, m, edges);
        for (int l = m; l <= order; ++l) {
            sum[harmonic_index(l, m)] += over_row[harmonic_index(l, m)] * moment.cosine;
            if (m > 0) sum[harmonic_index(l, -m)] += over_row[harmonic_index(l, m)] * moment.sine;
        }
    }
}

// Coefficients about the panorama's own pole. Blocks of rows are added in order, so the bits do
// not depend on the number of threads.
Coefficients about_the_pole(const Environment& environment, int order) {
    const int height = environment.height();
    const QuadratureRule rule = gauss_legendre(4 + 2 * int(std::ceil(order * pi / height)));
    const ColumnEdges edges(environment.width());
    const int blocks = std::min(height, 32);
    std::vector<Coefficients> partial(size_t(blocks),
                                      Coefficients(harmonic_count(order), Vec3d(0)));
    parallel_rows(blocks, [&](int block) {
        for (int y = height * block / blocks; y < height * (block + 1) / blocks; ++y)
            add_row(environment, y, order, rule, edges, partial[size_t(block)]);
    });
    for (size_t block = 1; block < partial.size(); ++block) add(partial[0], partial[block]);
    return partial[0];
}

// The real coefficients of a spectrum: a e^(i m phi) and its conjugate are sqrt 2 times Re a and
// -Im a of the real harmonics of m and -m.
Coefficients real_coefficients(const Spectrum& spectrum, int order) {
    Coefficients real(harmonic_count(order), Vec3d(0));
    for (int m = 0; m <= order; ++m)
        for (int l = m; l <= order; ++l) {
            const double* a = spectrum.order(m).data() + 6 * size_t(l - m);
            const double twice = m == 0 ? 1 : std::numbers::sqrt2;
            real[harmonic_index(l, m)] = twice * Vec3d(a[0], a[1], a[2]);
            if (m > 0) real[harmonic_index(l, -m)] = -twice * Vec3d(a[3], a[4], a[5]);
        }
    return real;
}

// The same function in the cube's axes: evaluated on a grid that integrates products of two
// harmonics exactly (Gauss-Legendre in z, uniform in azimuth), and projected again.
Coefficients in_cube_axes(const Coefficients& about_pole, int order,
                          const Mat3d& panorama_from_cube) {
    const QuadratureRule rule = gauss_legendre(order + 1);
    const int azimuths = 2 * order + 1;
    Coefficients result(about_pole.size(), Vec3d(0));
    std::vector<double> values(about_pole.size());
    for (size_t i = 0; i < rule.nodes.size(); ++i)
        for (int k = 0; k < azimuths; ++k) {
            const double azimuth = 2 * pi * k / azimuths;
            const double sine = std::sqrt(1 - rule.nodes[i] * rule.nodes[i]);
            const Vec3d d(sine * std::cos(azimuth), sine * std::sin(azimuth), rule.nodes[i]);
            evaluate_harmonics(pole_up(panorama_from_cube * d), order, values);
            Vec3d radiance(0);
            for (size_t j = 0; j < values.size(); ++j) radiance += values[j] * about_pole[j];
            evaluate_harmonics(d, order, values);
            const double weight = rule.weights[i] * 2 * pi / azimuths;
            for (size_t j = 0; j < values.size(); ++j) result[j] += weight * values[j] * radiance;
        }
    return result;
}

}  // namespace

std::vector<Vec3d> harmonics_of_environment(const Environment& environment, int order,
                                            const Mat3d& panorama_from_cube) {
    return in_cube_axes(about_the_pole(environment, order), order, panorama_from_cube);
}

std::vector<Vec3d> harmonics_of(const FilterSource& source, int order,
                                const Mat3d& panorama_from_cube) {
    if (!source.spectrum || source.spectrum->bands() <= order)
        return harmonics_of_environment(source.environment, order, panorama_from_cube);
    return in_cube_axes(real_coefficients(*source.spectrum, order), order, panorama_from_cube);
}

}  // namespace splitsum
