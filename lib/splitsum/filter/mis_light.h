#pragma once

#include <vector>

#include "splitsum/math/vec.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// Draws directions from where the light comes from and knows how likely each of them is.
///
/// What all directions have in common, the smallest value of each channel, is no reason to look
/// anywhere: it is split off as `floor`, to be added in closed form, and the rest is what is drawn
/// from. A constant environment leaves nothing, and is exact.
///
/// A texel is drawn in proportion to its solid angle and the mean of its channels above the floor
/// (by luminance a blue lamp would hardly be drawn), a direction uniformly over the texel's solid
/// angle. Memory: 8 bytes a texel. `environment` must outlive it.
class LightSampler {
public:
    explicit LightSampler(const Environment& environment);

    struct Sample {
        Vec3d direction;  ///< unit
        Vec3d light;      ///< radiance from there, above the floor
        double pdf;       ///< probability per steradian with which sample() returns `direction`
    };

    /// True if no texel is above the floor: then there is nothing to draw from.
    bool is_flat() const { return total_ == 0; }
    const Vec3d& floor() const { return floor_; }

    /// Maps u in [0, 1)² to a direction by inverting the distribution, rows by u.x, columns by u.y:
    /// monotonic in both, so that evenly spread points stay so. Not of a flat light. Cost: two
    /// binary searches.
    Sample sample(const Vec2d& u) const;

    /// The light from a unit direction, and how likely sample() is to return it.
    Sample towards(const Vec3d& direction) const;

private:
    Vec3d light_of(int x, int y) const { return Vec3d(environment_.texel(x, y)) - floor_; }
    Sample at(int x, int y, const Vec3d& direction) const;

    const Environment& environment_;
    Vec3d floor_;
    std::vector<double> column_ends_;   // per row, the sums of its weights up to each texel
    std::vector<double> row_ends_;      // the sums of weight times solid angle up to each row
    std::vector<double> edge_cosines_;  // of the polar angles between rows
    double total_ = 0;
};

}  // namespace splitsum
