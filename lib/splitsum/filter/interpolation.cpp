// Compiled once for each instruction set of this machine's family; the plain functions at the end
// choose among them at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "splitsum/filter/interpolation.cpp"
#include "splitsum/filter/interpolation.h"

#include <hwy/foreach_target.h>
// Highway's headers come in this order.
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace splitsum {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr size_t most_lanes = 8;  // directions at a time
constexpr size_t taps = 2 * SphereGrid::reach;

using Lanes = hn::CappedTag<double, most_lanes>;
using FloatLanes = hn::Rebind<float, Lanes>;
using IntLanes = hn::Rebind<int32_t, Lanes>;
using PointLanes = hn::CappedTag<float, 4>;
using Doubles = hn::Vec<Lanes>;
using Floats = hn::Vec<FloatLanes>;

// atan2(y, x) for y >= 0, in [0, pi].
HWY_INLINE Doubles angle_of(Doubles y, Doubles x) {
    const Lanes d;
    const Doubles ax = hn::Abs(x);
    const Doubles larger = hn::Max(hn::Max(ax, y), hn::Set(d, 1e-300));
    const Doubles acute = hn::Atan(d, hn::Div(hn::Min(ax, y), larger));
    const Doubles right = hn::Set(d, 0.5 * std::numbers::pi);
    const Doubles in_quadrant = hn::IfThenElse(hn::Gt(y, ax), hn::Sub(right, acute), acute);
    const auto behind = hn::Lt(x, hn::Zero(d));
    return hn::IfThenElse(behind, hn::Sub(hn::Set(d, std::numbers::pi), in_quadrant), in_quadrant);
}

// Where directions lie on the grid: the point to the upper left, and the weights of the six columns
// and six rings around it.
struct Places {
    int32_t column[most_lanes], ring[most_lanes];
    float across[taps][most_lanes], down[taps][most_lanes];
};

// Lagrange's polynomial through the points -2 .. 3, at t in [0, 1): the weight of each point.
HWY_INLINE void store_weights(Floats t, float (&weights)[taps][most_lanes]) {
    const FloatLanes df;
    const auto minus = [&](float x) HWY_ATTR { return hn::Sub(t, hn::Set(df, x)); };
    const auto times = [&](Floats x, float factor)
                           HWY_ATTR { return hn::Mul(x, hn::Set(df, factor)); };
    const Floats a = minus(-2), b = minus(-1), c = t, e = minus(1), f = minus(2), g = minus(3);
    const Floats ce = hn::Mul(c, e), bf = hn::Mul(b, f), ag = hn::Mul(a, g);
    const Floats weight[taps] = {times(hn::Mul(hn::Mul(bf, ce), g), -1 / 120.0f),
                                 times(hn::Mul(hn::Mul(ag, ce), f), 1 / 24.0f),
                                 times(hn::Mul(hn::Mul(ag, bf), e), -1 / 12.0f),
                                 times(hn::Mul(hn::Mul(ag, bf), c), 1 / 12.0f),
                                 times(hn::Mul(hn::Mul(ag, ce), b), -1 / 24.0f),
                                 times(hn::Mul(hn::Mul(bf, ce), a), 1 / 120.0f)};
    for (size_t i = 0; i < taps; ++i) hn::StoreU(weight[i], df, weights[i]);
}

// Splits a coordinate into its whole part, stored, and the rest.
HWY_INLINE Floats split(Doubles coordinate, int last, int32_t* whole) {
    const Lanes d;
    const Doubles floor = hn::Min(hn::Floor(coordinate), hn::Set(d, last));
    hn::StoreU(hn::DemoteTo(IntLanes(), floor), IntLanes(), whole);
    return hn::DemoteTo(FloatLanes(), hn::Sub(coordinate, floor));
}

HWY_INLINE void find_places(const SphereGrid& grid, const Vec3d* towards, Places& places) {
    const Lanes d;
    for (size_t i = 0; i < most_lanes; i += hn::Lanes(d)) {
        Doubles x, y, z;
        hn::LoadInterleaved3(d, &towards[i].x, x, y, z);
        const Doubles around = hn::CopySign(angle_of(hn::Abs(x), z), x);
        const Doubles polar = angle_of(hn::Sqrt(hn::MulAdd(x, x, hn::Mul(z, z))), y);
        const Doubles per_turn = hn::Set(d, grid.columns() / (2 * std::numbers::pi));
        const Doubles per_half_turn = hn::Set(d, grid.rings() / std::numbers::pi);
        const Doubles column = hn::MulAdd(around, per_turn, hn::Set(d, 0.5 * grid.columns()));
        const Doubles ring = hn::MulSub(polar, per_half_turn, hn::Set(d, 0.5));
        const Floats right = split(column, grid.columns() - 1, places.column + i);
        const Floats below = split(ring, grid.rings() - 1, places.ring + i);
        float across[taps][most_lanes], down[taps][most_lanes];
        store_weights(right, across);
        store_weights(below, down);
        for (size_t tap = 0; tap < taps; ++tap) {
            std::copy_n(across[tap], hn::Lanes(d), places.across[tap] + i);
            std::copy_n(down[tap], hn::Lanes(d), places.down[tap] + i);
        }
    }
}

HWY_INLINE Vec3 weighted_sum(const SphereGrid& grid, const Places& places, size_t i) {
    const PointLanes dp;
    const float* ring = grid.point(places.ring[i] - 2, places.column[i] - 2);
    auto sum = hn::Zero(dp);
    for (size_t j = 0; j < taps; ++j, ring += 4 * grid.stride()) {
        auto line = hn::Mul(hn::Set(dp, places.across[0][i]), hn::LoadU(dp, ring));
        for (size_t k = 1; k < taps; ++k)
            line = hn::MulAdd(hn::Set(dp, places.across[k][i]), hn::LoadU(dp, ring + 4 * k), line);
        sum = hn::MulAdd(hn::Set(dp, places.down[j][i]), line, sum);
    }
    float values[4] = {};
    hn::StoreU(sum, dp, values);
    return {values[0], values[1], values[2]};
}

void Interpolate(const SphereGrid& grid, std::span<const Vec3d> towards, std::span<Vec3> out) {
    Places places;
    Vec3d block[most_lanes];
    for (size_t first = 0; first < out.size(); first += most_lanes) {
        const size_t count = std::min(most_lanes, out.size() - first);
        std::copy_n(towards.begin() + ptrdiff_t(first), count, block);
        std::fill(block + count, block + most_lanes, Vec3d(0, 0, 1));
        find_places(grid, block, places);
        for (size_t i = 0; i < count; ++i) out[first + i] = weighted_sum(grid, places, i);
    }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace splitsum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splitsum {

HWY_EXPORT(Interpolate);

void interpolate(const SphereGrid& grid, std::span<const Vec3d> towards, std::span<Vec3> out) {
    HWY_DYNAMIC_DISPATCH(Interpolate)(grid, towards, out);
}

double interpolation_error(double angle) {
    // (5/2 3/2 1/2)² / 6!: the polynomial's nodes seen from the middle between two points.
    const double cube = angle * angle * angle;
    return std::min(1.0, 4.9e-3 * cube * cube);
}

}  // namespace splitsum
#endif  // HWY_ONCE
