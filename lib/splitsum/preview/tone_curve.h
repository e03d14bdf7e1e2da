#pragma once

namespace splitsum {

// How scene-linear Rec.709 becomes what an sRGB screen is sent, a channel at a time. The page has the
// same formulas.

/// IEC 61966-2-1: clipped to [0, 1] and encoded.
double srgb(double linear);

/// A filmic curve that compresses highlights: Narkowicz 2015, "ACES Filmic Tone Mapping Curve",
/// x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14), encoded by srgb(). Negative light counts as 0.
double filmic(double linear);

}  // namespace splitsum
