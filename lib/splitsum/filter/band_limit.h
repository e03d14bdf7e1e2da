#pragma once

#include <span>
#include <vector>

#include "splitsum/filter/spectrum.h"

namespace splitsum {

/// How many bands a lobe keeps, and the relative error (rel_rms over the sphere) that the rest
/// would have made at most.
struct BandLimit {
    int bands = 1;
    double truncation_bound = 0;
};

/// The smallest number of bands whose truncation bound is at most `accuracy`, or all that the
/// spectrum has if none is. `factors` are the lobe's band factors, at least as many as
/// spectrum.bands() and one more, which bounds those that follow: |k_l| must not grow from there on.
BandLimit band_limit(const Spectrum& spectrum, std::span<const double> factors, double accuracy);

/// How many bands a spectrum must have so that band_limit can succeed for a lobe with these factors
/// on any environment of that mean square and square mean (of ∫ L² dl and 4 pi mean²), before any
/// of it is transformed; factors.size() if those are too few.
int bands_needed(std::span<const double> factors, double total_power, double mean_power,
                 double accuracy);

}  // namespace splitsum
