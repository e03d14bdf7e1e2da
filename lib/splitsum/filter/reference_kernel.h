#pragma once

#include <array>
#include <cstddef>

#include "splitsum/brdf/lobe.h"
#include "splitsum/math/vec.h"

namespace splitsum {

/// Neighbouring texels of one row, seen from one direction.
struct TexelRun {
    size_t count;
    const float* texels;        ///< of the first one
    int floats_per_texel;       ///< 3 or 4, of which the first three are the radiance
    const double* sin_azimuth;  ///< of the middle of each
    const double* cos_azimuth;
};

/// One of a texel's Gauss points: the cosine with the lobe's direction is
/// constant + along_sin * sin(azimuth) + along_cos * cos(azimuth) at the azimuth of the texel's
/// middle (how far the point is from there has gone into the factors).
struct TexelNode {
    double constant;
    double along_sin;
    double along_cos;
};

/// A texel's 2 x 2 Gauss points: two rows of points that share a weight.
struct TexelNodes {
    std::array<std::array<TexelNode, 2>, 2> nodes;
    std::array<double, 2> weights;
};

/// The sum over nodes and texels of weight * lobe value * radiance, in fp64, on the widest
/// instruction set of the machine. The lobe's value comes from the cosine, so every node must be
/// far enough from the peak that 1 - cosine keeps its digits.
Vec3d sum_of_run(const Lobe& lobe, const TexelRun& run, const TexelNodes& nodes);

}  // namespace splitsum
