#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "splitsum/image/image.h"
#include "splitsum/math/vec.h"

namespace splitsum {

/// Light from everywhere: a lat-long grid whose texels are constant over their own solid angle.
/// Every integral in this library is defined on that piecewise-constant function, which makes
/// "exact" well defined.
///
/// Directions are in panorama space: azimuth atan2(x, z) grows to the right and is 0 in the middle
/// column, row 0 is at +Y. Texel (x, y) spans azimuths 2 pi (x / width - 1/2) onwards and polar
/// angles pi y / height onwards.
class Environment {
public:
    /// All texels black. `height` >= 1; the width is twice that.
    explicit Environment(int height);

    /// The pixels of a 2:1 image.
    explicit Environment(const Image& panorama);

    int width() const { return 2 * height_; }
    int height() const { return height_; }

    /// Four floats a texel: RGB and a 0 that lets a SIMD register hold a texel.
    std::span<const float> texels() const { return texels_; }
    Vec3 texel(int x, int y) const {
        const float* p = texels_.data() + index_of(x, y);
        return {p[0], p[1], p[2]};
    }
    void set_texel(int x, int y, const Vec3& radiance) {
        float* p = texels_.data() + index_of(x, y);
        p[0] = radiance.x, p[1] = radiance.y, p[2] = radiance.z;
    }

private:
    size_t index_of(int x, int y) const {
        return 4 * (static_cast<size_t>(y) * static_cast<size_t>(width()) + static_cast<size_t>(x));
    }

    int height_;
    std::vector<float> texels_;
};

/// The solid angle in steradians of a texel of row y: 2 pi / width (cos theta_y - cos theta_(y+1)),
/// in the product form that keeps its digits at the poles.
double solid_angle_of_row(int y, int height);

/// The direction with azimuth 2 pi (u - 1/2) and polar angle pi v.
Vec3d direction_of_lat_long(double u, double v);

struct LatLong {
    double u;  ///< in [0, 1], 1/2 at +Z, growing towards +X
    double v;  ///< in [0, 1], 0 at +Y
};

/// The inverse of direction_of_lat_long for a direction of any length but 0; exact to rounding at
/// the poles, where acos would lose half of the digits.
LatLong lat_long_towards(const Vec3d& direction);

/// The radiance of the texel that `direction` points into.
Vec3 radiance_towards(const Environment& environment, const Vec3d& direction);

/// The mean over the sphere, each texel weighted by its solid angle, summed in fp64.
Vec3d mean_radiance(const Environment& environment);

/// The same light on a coarser grid of `height` rows (any number up to the present one): each new
/// texel is the mean over its extent, weighted by exact solid angles, so the mean radiance stays.
Environment averaged_down(const Environment& environment, int height);

}  // namespace splitsum
