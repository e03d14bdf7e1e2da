#include "splitsum/filter/spectral.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "splitsum/filter/band_limit.h"
#include "splitsum/filter/spectrum.h"
#include "splitsum/filter/synthesis.h"

namespace splitsum {
namespace {

// Above this many bands the start values P_mm underflow where they matter.
constexpr int most_bands = 1800;

// The truncation's share of the accuracy that was asked for; interpolation and rounding have the
// rest.
constexpr double truncation_share = 0.3;

class SpectralFilter final : public PreparedFilter {
public:
    explicit SpectralFilter(std::vector<SphereGrid> grids) : grids_(std::move(grids)) {}

    void evaluate(size_t lobe_index, const Directions& directions,
                  std::span<Vec3> out) const override {
        for (size_t i = 0; i < out.size(); ++i)
            out[i] = interpolate(grids_[lobe_index], directions.towards[i]);
    }

private:
    std::vector<SphereGrid> grids_;
};

// ∫ L² dl and 4 pi |mean|², over the three channels.
struct Powers {
    double total;
    double mean;
};

Powers powers_of(const Environment& environment) {
    double total = 0;
    for (int y = 0; y < environment.height(); ++y) {
        double row = 0;
        for (int x = 0; x < environment.width(); ++x) {
            const Vec3d radiance(environment.texel(x, y));
            row += dot(radiance, radiance);
        }
        total += row * solid_angle_of_row(y, environment.height());
    }
    const Vec3d mean = mean_radiance(environment);
    return {total, 4 * std::numbers::pi * dot(mean, mean)};
}

}  // namespace

std::unique_ptr<PreparedFilter> prepare_spectral(const Environment& environment,
                                                 std::span<const Lobe> lobes,
                                                 const FilterPlan& plan) {
    const double accuracy = truncation_share * plan.accuracy;
    const Powers powers = powers_of(environment);
    const double negligible = negligible_factor(powers.total, powers.mean, accuracy);
    std::vector<std::vector<double>> factors;
    size_t bands = 1;
    for (const Lobe& lobe : lobes) {
        factors.push_back(significant_factors(lobe, negligible, most_bands));
        bands = std::max(bands, factors.back().size() - 1);
    }
    const Spectrum spectrum = forward_transform(environment, int(bands));
    std::vector<SphereGrid> grids;
    for (const std::vector<double>& k : factors) {
        const BandLimit limit = band_limit(spectrum, k, accuracy);
        grids.push_back(synthesize(spectrum, std::span(k).first(size_t(limit.bands))));
    }
    return std::make_unique<SpectralFilter>(std::move(grids));
}

}  // namespace splitsum
