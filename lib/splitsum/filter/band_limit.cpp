#include "splitsum/filter/band_limit.h"

#include <algorithm>
#include <cmath>

namespace splitsum {
namespace {

double square(double x) { return x * x; }

}  // namespace

BandLimit band_limit(const Spectrum& spectrum, std::span<const double> factors, double accuracy) {
    const size_t bands = size_t(spectrum.bands());
    double kept_power = 0, inside = 0;
    for (size_t l = 0; l < bands; ++l) {
        kept_power += square(factors[l]) * spectrum.power(int(l));
        inside += spectrum.power(int(l));
    }
    if (kept_power == 0) return {1, 0};  // black
    // From the highest band down, as long as what is left out stays under the limit.
    const double beyond = std::max(0.0, spectrum.total_power() - inside);
    double left_out = square(factors[bands]) * beyond;
    size_t limit = bands;
    while (limit > 1) {
        const double more = left_out + square(factors[limit - 1]) * spectrum.power(int(limit) - 1);
        if (more > square(accuracy) * kept_power) break;
        left_out = more;
        --limit;
    }
    return {int(limit), std::sqrt(left_out / kept_power)};
}

int bands_needed(std::span<const double> factors, double total_power, double mean_power,
                 double accuracy) {
    if (mean_power == 0) return 1;
    const double largest = accuracy * std::sqrt(mean_power / total_power);
    size_t bands = factors.size();
    while (bands > 1 && std::abs(factors[bands - 1]) <= largest) --bands;
    return int(bands);
}

}  // namespace splitsum
