#pragma once

#include <array>
#include <cstddef>

#include "splitsum/brdf/lobe.h"
#include "splitsum/math/vec.h"

namespace splitsum {

/// Neighbouring texels of one row with two Gauss points in azimuth each, seen from one direction.
struct TexelRun {
    size_t count;
    const float* texels;  ///< four floats a texel
    std::array<const double*, 2> sin_azimuth;
    std::array<const double*, 2> cos_azimuth;
};

/// One of the row's Gauss points in the polar angle: the cosine with the lobe's direction is
/// constant + along_sin * sin(azimuth) + along_cos * cos(azimuth).
struct RowNode {
    double constant;
    double along_sin;
    double along_cos;
    double weight;
};

/// The sum over nodes and texels of weight * lobe value * radiance, in fp64, on the widest
/// instruction set of the machine. The lobe's value comes from the cosine, so every node must be
/// far enough from the peak that 1 - cosine keeps its digits.
Vec3d sum_of_run(const Lobe& lobe, const TexelRun& run, const std::array<RowNode, 2>& nodes);

}  // namespace splitsum
