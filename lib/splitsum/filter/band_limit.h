#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "splitsum/brdf/lobe.h"
#include "splitsum/filter/filter_tables.h"
#include "splitsum/filter/spectrum.h"

namespace splitsum {

/// How many bands a lobe keeps, and the relative error (rel_rms over the sphere) that the rest
/// would have made at most.
struct BandLimit {
    int bands = 1;
    double truncation_bound = 0;
};

/// The factors of as many bands as it takes until all that follow are at most `smallest`, or of
/// `most` bands if that is not enough. Those that follow are taken to be no larger than the last
/// one, which holds from a few bands on for lobes that fall off steadily. Cost: O(bands²).
std::vector<double> significant_factors(FilterTables& tables, const Lobe& lobe, double smallest,
                                        int most);

/// How many bands leave out at most `accuracy` (rel_rms) of the lobe around a single point light,
/// whose power is the same for every harmonic; nothing if that takes more than `most`.
std::optional<int> bands_for_point_light(FilterTables& tables, const Lobe& lobe, double accuracy,
                                         int most);

/// The size below which a factor cannot matter to an environment with these powers (∫ L² dl and
/// 4 pi mean²): leaving out all bands with smaller factors costs at most `accuracy`.
double negligible_factor(double total_power, double mean_power, double accuracy);

/// The smallest number of bands whose truncation bound is at most `accuracy`, or as many as spectrum
/// and factors have, and `most` allows, if none is. The last factor is not used as such: it bounds
/// all that follow.
///
/// Of bands that were never transformed the power is bounded twice, and the smaller bound counts:
/// together they have what is left of ∫ L² dl, and a band of light without negative parts has at most
/// the 2 l + 1 fold power of band 0, which is what a single point has (|P_l| <= 1 in the addition
/// theorem; DLMF 14.30.9).
BandLimit band_limit(const Spectrum& spectrum, std::span<const double> factors, double accuracy,
                     int most = std::numeric_limits<int>::max());

}  // namespace splitsum
