#pragma once

#include <array>

namespace splitsum {

/// CIE 1931 chromaticities x, y of red, green, blue and white, in this order.
using Primaries = std::array<double, 8>;

/// Row by row: out[i] = sum over j of m[3 * i + j] * in[j].
using ColorMatrix = std::array<double, 9>;

inline constexpr Primaries rec709_primaries = {0.64, 0.33, 0.30,   0.60,
                                               0.15, 0.06, 0.3127, 0.3290};  // ITU-R BT.709-6
inline constexpr Primaries rec2020_primaries = {0.708, 0.292, 0.170,  0.797,
                                                0.131, 0.046, 0.3127, 0.3290};  // ITU-R BT.2020-2
inline constexpr Primaries p3_d65_primaries = {0.680, 0.320, 0.265,  0.690,
                                               0.150, 0.060, 0.3127, 0.3290};  // SMPTE EG 432-1
inline constexpr Primaries aces_ap0_primaries = {0.7347,  0.2653,  0.0,    1.0, 0.0001,
                                                 -0.0770, 0.32168, 0.33767};  // SMPTE ST 2065-1
inline constexpr Primaries aces_ap1_primaries = {
    0.713, 0.293, 0.165, 0.830, 0.128, 0.044, 0.32168, 0.33767};  // ACES S-2014-004, ACEScg

/// True where white can be reached with positive amounts of three independent primaries: what
/// follows is defined then.
bool are_usable(const Primaries& primaries);

/// Linear RGB to CIE XYZ, (1, 1, 1) to white with Y = 1 (SMPTE RP 177-1993). Primaries must be usable.
ColorMatrix xyz_from_rgb(const Primaries& primaries);

/// Linear RGB of one set of primaries to another. Where the whites differ, white is taken to white
/// by the Bradford transform (Lam 1985; ICC.1:2010 annex E). Primaries must be usable.
ColorMatrix rgb_from_rgb(const Primaries& to, const Primaries& from);

/// CIE XYZ, relative to a D65 white with Y = 1, to linear Rec.709.
ColorMatrix rec709_from_xyz_d65();

}  // namespace splitsum
