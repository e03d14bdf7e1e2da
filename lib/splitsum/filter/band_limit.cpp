#include "splitsum/filter/band_limit.h"

#include <algorithm>
#include <cmath>

namespace splitsum {
namespace {

double square(double x) { return x * x; }

// No light without negative parts has more in any band.
bool is_within_power_of_point(const Spectrum& spectrum, int bands) {
    constexpr double rounding = 1 + 1e-6;
    for (int l = 1; l < bands; ++l)
        if (spectrum.power(l) > rounding * (2 * l + 1) * spectrum.power(0)) return false;
    return true;
}

// What the filtered light can have in the bands from `bands` on, which were not transformed.
double power_beyond(const Spectrum& spectrum, std::span<const double> factors, size_t bands) {
    double rest = spectrum.total_power();
    for (size_t l = 0; l < bands; ++l) rest -= spectrum.power(int(l));
    rest = std::max(rest, 0.0);
    double largest_factor = 0, of_point = 0;
    for (size_t l = bands; l < factors.size(); ++l) {
        largest_factor = std::max(largest_factor, std::abs(factors[l]));
        of_point += square(factors[l]) * double(2 * l + 1) * spectrum.power(0);
    }
    const double by_rest = square(largest_factor) * rest;
    if (!is_within_power_of_point(spectrum, int(bands))) return by_rest;
    return std::min(by_rest, of_point + square(factors.back()) * rest);
}

}  // namespace

std::vector<double> significant_factors(FilterTables& tables, const Lobe& lobe, double smallest,
                                        int most) {
    for (int count = 64;; count *= 2) {
        const auto known = tables.band_factors(lobe, std::min(count, most) + 1);
        const std::span factors(*known);
        // The clamped cosine has no odd bands: two in a row tell that it is over.
        size_t needed = factors.size();
        while (needed > 1 && std::abs(factors[needed - 1]) <= smallest) --needed;
        if (needed + 2 <= factors.size() || count >= most)
            return {factors.begin(), factors.begin() + std::min(factors.size(), needed + 2)};
    }
}

std::optional<int> bands_for_point_light(FilterTables& tables, const Lobe& lobe, double accuracy,
                                         int most) {
    const std::vector<double> factors = significant_factors(tables, lobe, 1e-3 * accuracy, most);
    const auto power = [&](size_t l) { return square(factors[l]) * double(2 * l + 1); };
    double whole = 0;
    for (size_t l = 0; l < factors.size(); ++l) whole += power(l);
    double left_out = 0;
    for (size_t bands = factors.size() - 1; bands > 0; --bands) {
        left_out += power(bands);
        if (left_out <= square(accuracy) * whole) continue;
        const bool complete = bands + 1 < factors.size();
        return complete ? std::optional(int(bands) + 1) : std::nullopt;
    }
    return 1;
}

double negligible_factor(double total_power, double mean_power, double accuracy) {
    if (total_power == 0) return 1;  // black: nothing matters
    // The share of the sphere that is lit is at least that of one texel, unless light has negative
    // parts; then the factor is a guess.
    constexpr double least_share = 1e-13;
    const double share = mean_power / total_power;
    constexpr double smallest_known = 1e-11;  // factors are known to 1e-12
    return std::max(smallest_known, accuracy * (share > least_share ? std::sqrt(share) : 1e-3));
}

BandLimit band_limit(const Spectrum& spectrum, std::span<const double> factors, double accuracy,
                     int most) {
    const size_t bands = std::min(size_t(spectrum.bands()), factors.size() - 1);
    double kept_power = 0;
    for (size_t l = 0; l < bands; ++l) kept_power += square(factors[l]) * spectrum.power(int(l));
    if (kept_power == 0) return {1, 0};  // black
    // From the highest band down, as long as what is left out stays under the limit.
    double left_out = power_beyond(spectrum, factors, bands);
    size_t limit = bands;
    while (limit > 1) {
        const double more = left_out + square(factors[limit - 1]) * spectrum.power(int(limit) - 1);
        if (more > square(accuracy) * kept_power && limit <= size_t(most)) break;
        left_out = more;
        --limit;
    }
    return {int(limit), std::sqrt(left_out / kept_power)};
}

}  // namespace splitsum
