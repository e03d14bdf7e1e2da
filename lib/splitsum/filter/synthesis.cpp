#include "splitsum/filter/synthesis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/buffer.h"
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
    Buffer<float> values;

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
        for (size_t c = 0; c < 2 * complex_rgb; ++c)
            std::fill_n(fourier.even(m) + c * fourier.rings, first, 0.0f);
        sum_order(LegendreOrder(m, bands), bands, angles.cosine, angles.sine, first,
                  coefficients.data(), fourier.even(m), fourier.odd(m));
    });
    return fourier;
}

// One channel of a few neighbouring northern rings and their southern mirrors, whose coefficients
// are side by side in memory.
struct RingBlock {
    static constexpr int most_rings = 8;

    int first_ring;
    int count;
    size_t channel;
};

// Both rings of a pair at once: the northern as real part, the southern as imaginary part.
void transform_ring_pairs(const RingFourier& fourier, int bands, const RingBlock& block,
                          const Fft& fft, SphereGrid& grid) {
    const size_t columns = size_t(grid.columns()), count = size_t(block.count);
    const size_t imaginary = 3 * fourier.rings, to_odd = complex_rgb * fourier.rings;
    std::vector<FftValue> bins(count * columns, FftValue{0, 0}), values(columns);
    for (int m = 0; m < bands; ++m) {
        const float* even =
            fourier.even(m) + block.channel * fourier.rings + size_t(block.first_ring);
        const float* odd = even + to_odd;
        // Columns begin at azimuth -pi, which changes the sign of odd orders.
        const float sign = m % 2 == 0 ? 1.0f : -1.0f;
        for (size_t i = 0; i < count; ++i) {
            const float nr = sign * (even[i] + odd[i]), sr = sign * (even[i] - odd[i]);
            const float ni = sign * (even[i + imaginary] + odd[i + imaginary]);
            const float si = sign * (even[i + imaginary] - odd[i + imaginary]);
            FftValue* ring = bins.data() + i * columns;
            ring[m] = {nr - si, ni + sr};
            if (m > 0) ring[columns - size_t(m)] = {nr + si, sr - ni};
        }
    }
    for (size_t i = 0; i < count; ++i) {
        const int ring = block.first_ring + int(i);
        fft.transform(std::span(bins).subspan(i * columns, columns), values);
        float* north = grid.point(ring, 0) + block.channel;
        float* south = grid.point(grid.rings() - 1 - ring, 0) + block.channel;
        for (size_t x = 0; x < columns; ++x) {
            north[4 * x] = values[x].r;
            south[4 * x] = values[x].i;
        }
        if (block.channel != 2) continue;
        for (size_t x = 0; x < columns; ++x) north[4 * x + 1] = south[4 * x + 1] = 0;
    }
}

void transform_rings(const RingFourier& fourier, int bands, SphereGrid& grid) {
    const Fft fft(grid.columns(), Fft::Direction::inverse);
    const int northern = grid.rings() / 2;
    const int blocks = (northern + RingBlock::most_rings - 1) / RingBlock::most_rings;
    parallel_rows(3 * blocks, [&](int task) {
        const int first = task / 3 * RingBlock::most_rings;
        transform_ring_pairs(
            fourier, bands,
            {first, std::min(RingBlock::most_rings, northern - first), size_t(task % 3)}, fft,
            grid);
    });
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
    transform_rings(fourier, bands, grid);
    grid.continue_edges();
    return grid;
}

}  // namespace splitsum
