#pragma once

#include <vector>

#include "splitsum/brdf/lobe.h"
#include "splitsum/math/vec.h"

namespace splitsum {

/// One row of an environment's texels.
struct TexelRow {
    int y;
    const float* texels;
    int floats_per_texel;  ///< 3 or 4, of which the first three are the radiance

    Vec3 texel(int x) const {
        const float* p = texels + floats_per_texel * x;
        return {p[0], p[1], p[2]};
    }
};

/// Integrals of lobe times environment over one row of texels in fp64, so that a sum over rows does
/// not ask for all of them at once.
///
/// Far from the lobe's peak a texel takes 2 x 2 Gauss points; within `near_texels` texels of it, and
/// where the horizon cuts it, a texel is integrated by lobe_over_patch.
class RowQuadrature {
public:
    /// Of environments of `height` rows. With 25 near texels the relative error is below 1e-7; with 4
    /// it is below 1e-5 for lobes narrower than a texel.
    RowQuadrature(int height, double near_texels);

    int height() const { return height_; }

    /// A lobe's unit direction, and where it lies in the grid.
    struct Towards {
        Vec3d direction;
        double theta;
        double column;  ///< 0 at the left edge of column 0
    };
    Towards towards(const Vec3d& direction) const;

    /// The row's part of ∫ L K dl over the hemisphere around the direction, not divided by the lobe's
    /// integral.
    Vec3d over_hemisphere(const Lobe& lobe, const Towards& towards, const TexelRow& row) const;

    /// The same over the row's texels within `radius` radians (below pi / 2), about as many.
    Vec3d over_cap(const Lobe& lobe, const Towards& towards, const TexelRow& row,
                   double radius) const;

private:
    struct RowParts;

    int width() const { return 2 * height_; }
    double row_height() const;
    double column_width() const;
    Vec3d row_integral(const Lobe& lobe, const Towards& towards, const TexelRow& row,
                       const RowParts& parts) const;
    RowParts hemisphere_parts(const Lobe& lobe, const Towards& towards, int y) const;
    RowParts cap_parts(const Lobe& lobe, const Towards& towards, int y, double radius) const;
    void mark_near(const Lobe& lobe, const Towards& towards, int y, RowParts& parts) const;
    double near_azimuth(const Lobe& lobe, double theta, int y) const;
    Vec3d careful(const Lobe& lobe, const Towards& towards, const TexelRow& row, int begin,
                  int end) const;
    double over_azimuths(const Lobe& lobe, double lobe_theta, int y, double from, double to) const;
    Vec3d plain(const Lobe& lobe, const Towards& towards, const TexelRow& row, int begin,
                int end) const;
    int wrapped(int x) const;

    int height_;
    double near_texels_;
    std::vector<double> sin_azimuth_;  // at the middle of every column
    std::vector<double> cos_azimuth_;
};

}  // namespace splitsum
