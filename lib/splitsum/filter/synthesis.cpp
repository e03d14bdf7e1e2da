#include "splitsum/filter/synthesis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/filter/fft.h"
#include "splitsum/filter/interpolation.h"
#include "splitsum/filter/legendre_kernels.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

// Polar angles of the northern rings, padded.
struct NorthernRings {
    std::vector<double> cosine, sine;

    explicit NorthernRings(int rings)
        : cosine(padded(size_t(rings / 2)), 0.0), sine(padded(size_t(rings / 2)), 1.0) {
        for (int k = 0; k < rings / 2; ++k) {
            cosine[size_t(k)] = std::cos(pi * (k + 0.5) / rings);
            sine[size_t(k)] = std::sin(pi * (k + 0.5) / rings);
        }
    }
};

// [order][even, odd][complex_rgb][northern ring]: the Fourier coefficients along each ring.
struct RingFourier {
    size_t rings;  // northern, padded
    std::vector<float> values;

    RingFourier(size_t padded_rings, int orders)
        : rings(padded_rings), values(size_t(orders) * 2 * complex_rgb * padded_rings) {}

    float* even(int m) { return values.data() + size_t(m) * 2 * complex_rgb * rings; }
    float* odd(int m) { return even(m) + complex_rgb * rings; }
    const float* even(int m) const { return const_cast<RingFourier*>(this)->even(m); }
};

// The coefficients of order m, each band multiplied by its factor.
std::vector<double> filtered_order(const Spectrum& spectrum, std::span<const double> factors,
                                   int m) {
    const auto order = spectrum.order(m);
    std::vector<double> scaled(complex_rgb * (factors.size() - size_t(m)));
    for (size_t i = 0; i < scaled.size(); ++i)
        scaled[i] = order[i] * factors[size_t(m) + i / complex_rgb];
    return scaled;
}

RingFourier fourier_of_rings(const Spectrum& spectrum, std::span<const double> factors,
                             const NorthernRings& angles) {
    const int bands = int(factors.size());
    RingFourier fourier(angles.cosine.size(), bands);
    parallel_rows(bands, [&](int m) {
        const std::vector<double> coefficients = filtered_order(spectrum, factors, m);
        const size_t first = first_relevant_angle(m, bands, angles.sine);
        sum_order(LegendreOrder(m, bands), bands, angles.cosine, angles.sine, first,
                  coefficients.data(), fourier.even(m), fourier.odd(m));
    });
    return fourier;
}

// Both rings of a pair at once: the northern as real part, the southern as imaginary part.
void transform_ring_pair(const RingFourier& fourier, int bands, int ring, const Fft& fft,
                         SphereGrid& grid) {
    const size_t columns = size_t(grid.columns());
    std::vector<FftValue> bins(columns), values(columns);
    for (size_t channel = 0; channel < 3; ++channel) {
        std::ranges::fill(bins, FftValue{0, 0});
        for (int m = 0; m < bands; ++m) {
            const float* even = fourier.even(m) + channel * fourier.rings + size_t(ring);
            const float* odd = even + complex_rgb * fourier.rings;
            const size_t imaginary = 3 * fourier.rings;
            // Columns begin at azimuth -pi, which changes the sign of odd orders.
            const float sign = m % 2 == 0 ? 1.0f : -1.0f;
            const float nr = sign * (even[0] + odd[0]);
            const float ni = sign * (even[imaginary] + odd[imaginary]);
            const float sr = sign * (even[0] - odd[0]);
            const float si = sign * (even[imaginary] - odd[imaginary]);
            bins[size_t(m)] = {nr - si, ni + sr};
            if (m > 0) bins[columns - size_t(m)] = {nr + si, sr - ni};
        }
        fft.transform(bins, values);
        float* north = grid.point(ring, 0) + channel;
        float* south = grid.point(grid.rings() - 1 - ring, 0) + channel;
        for (size_t x = 0; x < columns; ++x) {
            north[4 * x] = values[x].r;
            south[4 * x] = values[x].i;
        }
    }
}

}  // namespace

GridSize grid_size(const Spectrum& spectrum, std::span<const double> factors, double accuracy) {
    const int bands = int(factors.size());
    const auto bound = [&](int rings) {
        double missed = 0, whole = 0;
        for (int l = 0; l < bands; ++l) {
            const double power = factors[size_t(l)] * factors[size_t(l)] * spectrum.power(l);
            const double error = interpolation_error(l * pi / rings);
            missed += error * error * power;
            whole += power;
        }
        return whole > 0 ? std::sqrt(missed / whole) : 0.0;
    };
    const int most = std::max(8 * bands, 2 * SphereGrid::reach);
    int rings = std::max(bands + bands % 2, 2 * SphereGrid::reach);
    while (rings < most && bound(rings) > accuracy)
        rings = std::min(most, rings + 2 * std::max(1, rings / 32));
    return {rings, bound(rings)};
}

SphereGrid synthesize(const Spectrum& spectrum, std::span<const double> factors, int rings) {
    const int bands = int(factors.size());
    SphereGrid grid(rings, Fft::fast_length(2 * rings));
    const RingFourier fourier = fourier_of_rings(spectrum, factors, NorthernRings(rings));
    const Fft fft(grid.columns(), Fft::Direction::inverse);
    parallel_rows(rings / 2,
                  [&](int ring) { transform_ring_pair(fourier, bands, ring, fft, grid); });
    grid.continue_edges();
    return grid;
}

}  // namespace splitsum
