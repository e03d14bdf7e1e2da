#include "splitsum/filter/spectral.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "splitsum/base/parallel.h"
#include "splitsum/filter/band_limit.h"
#include "splitsum/filter/interpolation.h"
#include "splitsum/filter/narrow_lobe.h"
#include "splitsum/filter/spectrum.h"
#include "splitsum/filter/synthesis.h"

namespace splitsum {
namespace {

// Where more bands cost more than taking the lobe apart (filter/README.md has the measurement).
constexpr int most_bands = 2000;

// Shares of the accuracy that was asked for: bands left out, interpolation, the cut of a narrow
// lobe's rest. Far below 1 together, because these errors lie around bright lights while a figure
// taken at a few texels may see the dark beside them: 64 texels of a studio of soft boxes showed
// 9e-4 with 0.3 and 3.4e-4 with 0.1; with 0.05 no capture shows more than 2e-4.
constexpr double truncation_share = 0.05;
constexpr double largest_truncation_share = 0.5;  // where the bands were chosen before the light
// The horizon of a rough lobe has some power in every band, and under a point of light in darkness
// the last digits of it take thousands: no more are kept than a point takes for this share. It shows
// where that is dark, on texels that the light itself does not reach.
constexpr double horizon_truncation_share = 0.2;
constexpr double interpolation_share = 0.05;
constexpr double cap_share = 0.1;

// Of the texels around a narrow lobe's peak that are integrated with care.
constexpr double near_texels = 4;

// How one lobe is filtered.
struct LobePlan {
    Lobe transformed;                  // what the transform filters with
    std::vector<double> factors;       // its significant band factors
    int most_kept = most_bands;        // of them, under any light
    std::optional<NarrowLobe> narrow;  // what is added for a narrow lobe
};

struct FilteredLobe {
    SphereGrid grid{0, 0};
    std::optional<NarrowLobe> narrow;
    LevelAccount account;
};

class SpectralFilter final : public PreparedFilter {
public:
    SpectralFilter(const Environment& environment, std::vector<FilteredLobe> lobes)
        : lobes_(std::move(lobes)) {
        const auto is_narrow = [](const FilteredLobe& lobe) { return lobe.narrow.has_value(); };
        if (std::ranges::any_of(lobes_, is_narrow)) quadrature_.emplace(environment, near_texels);
    }

    void evaluate(size_t lobe_index, const Directions& directions,
                  std::span<Vec3> out) const override {
        const FilteredLobe& lobe = lobes_[lobe_index];
        interpolate(lobe.grid, directions.towards, out);
        if (!lobe.narrow) return;
        for (size_t i = 0; i < out.size(); ++i)
            out[i] = Vec3(lobe.narrow->share() * Vec3d(out[i]) +
                          lobe.narrow->rest(*quadrature_, directions.towards[i]));
    }

    LevelAccount account(size_t lobe_index) const override { return lobes_[lobe_index].account; }

private:
    std::vector<FilteredLobe> lobes_;
    std::optional<TexelQuadrature> quadrature_;  // where a lobe is narrow
};

// The size below which a band factor cannot matter to this light.
double negligible_for(const Spectrum& spectrum, double accuracy) {
    return negligible_factor(spectrum.total_power(), spectrum.power(0), accuracy);
}

double negligible_for(const FilterSource& source, double accuracy) {
    if (source.spectrum) return negligible_for(*source.spectrum, accuracy);
    const Vec3d mean = mean_radiance(source.environment);
    return negligible_factor(integral_of_square(source.environment),
                             4 * std::numbers::pi * dot(mean, mean), accuracy);
}

bool has_horizon(const Lobe& lobe) {
    constexpr double narrow = 0.5;  // radians
    return lobe_width(lobe) > narrow;
}

// How many bands the lobe takes under a point light, the worst that can shine on it, if that is
// within reach. Of rough lobes nothing is said: few lights need what a point does.
std::optional<int> bands_of_narrow(FilterTables& tables, const Lobe& lobe, double accuracy) {
    if (has_horizon(lobe)) return 1;
    return bands_for_point_light(tables, lobe, truncation_share * accuracy, most_bands);
}

int most_kept_of(FilterTables& tables, const Lobe& lobe, double accuracy) {
    if (!has_horizon(lobe)) return most_bands;
    return bands_for_point_light(tables, lobe, horizon_truncation_share * accuracy, most_bands)
        .value_or(most_bands);
}

LobePlan plan_lobe(FilterTables& tables, const Lobe& lobe, double negligible, double accuracy) {
    Lobe wide = lobe;
    while (!bands_of_narrow(tables, wide, accuracy)) wide.alpha *= 1.25;
    LobePlan plan{wide, significant_factors(tables, wide, negligible, most_bands),
                  most_kept_of(tables, wide, accuracy), std::nullopt};
    if (wide.alpha > lobe.alpha) plan.narrow.emplace(lobe.alpha, wide.alpha, cap_share * accuracy);
    return plan;
}

// As many bands as these lobes can need, or fewer where what they leave out turns out not to matter.
Spectrum transform_for(const FilterSource& source, std::span<const Lobe> lobes,
                       const std::vector<LobePlan>& plans, double accuracy) {
    int most = 1;
    for (const LobePlan& plan : plans)
        most = std::max(most, std::min(int(plan.factors.size()) - 1, plan.most_kept));
    const int guess = bands_to_transform(*source.tables, lobes, accuracy).value_or(most);
    Spectrum spectrum = forward_transform(source.environment, std::min(guess, most));
    const bool enough = std::ranges::all_of(plans, [&](const LobePlan& plan) {
        const double bound = truncation_share * accuracy;
        return band_limit(spectrum, plan.factors, bound).truncation_bound <= 2 * bound;
    });
    return enough ? std::move(spectrum) : forward_transform(source.environment, most);
}

FilteredLobe filter_lobe(const Spectrum& spectrum, const LobePlan& plan, double accuracy) {
    const BandLimit limit =
        band_limit(spectrum, plan.factors, truncation_share * accuracy, plan.most_kept);
    const auto factors = std::span(plan.factors).first(size_t(limit.bands));
    const GridSize size = grid_size(spectrum, factors, interpolation_share * accuracy);
    LevelAccount account{.method = "spectral", .bands = limit.bands};
    const double cut = plan.narrow ? cap_share * accuracy : 0;
    account.error_bound = std::hypot(limit.truncation_bound, size.interpolation_bound, cut);
    return {synthesize(spectrum, factors, size.rings), plan.narrow, account};
}

}  // namespace

std::unique_ptr<PreparedFilter> prepare_spectral(const FilterSource& source,
                                                 std::span<const Lobe> lobes,
                                                 const FilterPlan& plan) {
    const double negligible = negligible_for(source, truncation_share * plan.accuracy);
    std::vector<LobePlan> plans(lobes.size());
    parallel_rows(int(lobes.size()), [&](int i) {
        plans[size_t(i)] = plan_lobe(*source.tables, lobes[size_t(i)], negligible, plan.accuracy);
    });
    std::optional<Spectrum> own;
    if (!source.spectrum) own = transform_for(source, lobes, plans, plan.accuracy);
    const Spectrum& spectrum = source.spectrum ? *source.spectrum : *own;
    std::vector<FilteredLobe> filtered(lobes.size());
    parallel_rows(int(lobes.size()), [&](int i) {
        filtered[size_t(i)] = filter_lobe(spectrum, plans[size_t(i)], plan.accuracy);
    });
    return std::make_unique<SpectralFilter>(source.environment, std::move(filtered));
}

std::optional<int> bands_to_transform(FilterTables& tables, std::span<const Lobe> lobes,
                                      double accuracy) {
    int bands = 256;  // for the rough ones
    for (const Lobe& lobe : lobes) {
        const auto needed = bands_of_narrow(tables, lobe, accuracy);
        if (!needed) return std::nullopt;
        bands = std::max(bands, *needed);
    }
    return bands;
}

int bands_needed(FilterTables& tables, const Spectrum& spectrum, std::span<const Lobe> lobes,
                 double accuracy) {
    const double negligible = negligible_for(spectrum, truncation_share * accuracy);
    int bands = spectrum.bands();
    for (const Lobe& lobe : lobes) {
        const auto factors = significant_factors(tables, lobe, negligible, most_bands);
        const double bound =
            band_limit(spectrum, factors, truncation_share * accuracy).truncation_bound;
        if (bound > largest_truncation_share * accuracy)
            bands = std::max(
                bands, std::min(int(factors.size()) - 1, most_kept_of(tables, lobe, accuracy)));
    }
    return bands;
}

}  // namespace splitsum
