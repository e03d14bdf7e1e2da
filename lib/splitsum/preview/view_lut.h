#pragma once

#include <cstdint>
#include <vector>

#include "splitsum/math/vec.h"
#include "splitsum/preview/view.h"

namespace splitsum {

/// A View as a 3D texture, for renderers that cannot run OpenColorIO. Its twin is
/// page/view_lut.glsl.
///
/// Texel centre i of an axis, counted from 0, stands for the linear value v at
/// log2(1 + steepness v) = i / (size - 1) log2(1 + steepness brightest): about even steps in stops
/// above 1 / steepness, and even ones below. Outside of [0, brightest] values are clamped.
struct ViewLut {
    int size = 0;                 ///< texels along each axis
    std::vector<uint32_t> rgb10;  ///< 10 bits each, red lowest; red runs fastest, then green

    static constexpr double steepness = 512;
    static constexpr double brightest = 64;
};

/// Samples the view, which takes milliseconds. With 32 texels along the axes what look_up() returns for
/// the view `aces` is 0.13/255 off in the mean and 0.6/255 at the 99th percentile, over colours of every
/// saturation from 2^-10 to 2^5; single saturated colours are up to 9/255 off.
ViewLut view_lut_of(const View& view, int size = 32);

/// What a linear filter reads from the texture for scene-linear Rec.709.
Vec3d look_up(const ViewLut& lut, const Vec3d& linear);

}  // namespace splitsum
