// Compiled once for each instruction set of this machine's family; the plain functions at the end
// choose among them at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "splitsum/filter/sample_kernels.cpp"
#include "splitsum/filter/sample_kernels.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace splitsum {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using FloatLanes = hn::CappedTag<float, SampleSet::padding>;
using IntLanes = hn::RebindToSigned<FloatLanes>;
using TexelLanes = hn::CappedTag<float, 4>;
using Floats = hn::Vec<FloatLanes>;
using TexelVec = hn::Vec<TexelLanes>;

// atan2(y, x) in turns, (-1/2, 1/2]. The polynomial is the minimax fit of atan(t) / (2 pi) by odd
// powers on [0, 1] (Remez exchange, error 6e-9 before rounding); the rest is symmetry.
HWY_INLINE Floats turns_of(Floats y, Floats x) {
    const FloatLanes d;
    const Floats ay = hn::Abs(y), ax = hn::Abs(x);
    const Floats larger = hn::Max(hn::Max(ax, ay), hn::Set(d, 1e-30f));
    const Floats t = hn::Div(hn::Min(ax, ay), larger);
    const Floats s = hn::Mul(t, t);
    Floats p = hn::Set(d, -6.4530439e-4f);
    p = hn::MulAdd(p, s, hn::Set(d, 3.47959771e-3f));
    p = hn::MulAdd(p, s, hn::Set(d, -8.89872301e-3f));
    p = hn::MulAdd(p, s, hn::Set(d, 1.53460335e-2f));
    p = hn::MulAdd(p, s, hn::Set(d, -2.21362714e-2f));
    p = hn::MulAdd(p, s, hn::Set(d, 3.17459452e-2f));
    p = hn::MulAdd(p, s, hn::Set(d, -5.30461210e-2f));
    p = hn::MulAdd(p, s, hn::Set(d, 0.159154837f));
    p = hn::Mul(p, t);
    p = hn::IfThenElse(hn::Gt(ay, ax), hn::Sub(hn::Set(d, 0.25f), p), p);
    p = hn::IfThenElse(hn::Lt(x, hn::Zero(d)), hn::Sub(hn::Set(d, 0.5f), p), p);
    return hn::CopySign(p, y);
}

struct LatLongLanes {
    Floats u, v;
};

// Where Lanes samples, turned by the frame, meet the panorama: u and v in [0, 1].
HWY_INLINE LatLongLanes lat_long_of(const SampleSet& samples, size_t i, const Frame& frame) {
    const FloatLanes d;
    const Floats sx = hn::LoadU(d, &samples.x[i]);
    const Floats sy = hn::LoadU(d, &samples.y[i]);
    const Floats sz = hn::LoadU(d, &samples.z[i]);
    const auto component = [&](int c) HWY_ATTR {
        const Floats in_plane = hn::MulAdd(hn::Set(d, frame.bitangent[c]), sy,
                                           hn::Mul(hn::Set(d, frame.tangent[c]), sx));
        return hn::MulAdd(hn::Set(d, frame.normal[c]), sz, in_plane);
    };
    const Floats x = component(0), y = component(1), z = component(2);
    const Floats horizontal = hn::Sqrt(hn::MulAdd(x, x, hn::Mul(z, z)));
    const Floats half_turns = turns_of(horizontal, y);
    return {hn::Add(hn::Set(d, 0.5f), turns_of(x, z)), hn::Add(half_turns, half_turns)};
}

// Adds a block and keeps what the addition rounds off for the next one (Kahan 1965): 16384 equal
// samples added plainly drift by 1.6e-4.
HWY_INLINE void add_block(TexelVec block, TexelVec& sum, TexelVec& lost) {
    const TexelVec corrected = hn::Sub(block, lost);
    const TexelVec total = hn::Add(sum, corrected);
    lost = hn::Sub(hn::Sub(total, sum), corrected);
    sum = total;
}

HWY_INLINE Vec3 rgb_of(TexelVec sum) {
    float values[4] = {};
    hn::StoreU(sum, TexelLanes(), values);
    return {values[0], values[1], values[2]};
}

Vec3 TexelSum(const Environment& environment, const SampleSet& samples, const Frame& frame) {
    const FloatLanes d;
    const IntLanes di;
    const TexelLanes dt;
    const Floats width = hn::Set(d, float(environment.width()));
    const Floats height = hn::Set(d, float(environment.height()));
    const auto last_column = hn::Set(di, environment.width() - 1);
    const auto last_row = hn::Set(di, environment.height() - 1);
    const float* texels = environment.texels().data();

    HWY_ALIGN int32_t texel[SampleSet::padding];
    TexelVec sum = hn::Zero(dt), lost = hn::Zero(dt);
    for (size_t i = 0; i < samples.x.size(); i += hn::Lanes(d)) {
        const LatLongLanes at = lat_long_of(samples, i, frame);
        const auto column = hn::Min(hn::ConvertTo(di, hn::Mul(at.u, width)), last_column);
        const auto row = hn::Min(hn::ConvertTo(di, hn::Mul(at.v, height)), last_row);
        hn::Store(hn::Add(hn::Mul(row, hn::Set(di, environment.width())), column), di, texel);
        TexelVec block = hn::Zero(dt);
        for (size_t lane = 0; lane < hn::Lanes(d); ++lane)
            block = hn::MulAdd(hn::Set(dt, samples.weight[i + lane]),
                               hn::LoadU(dt, texels + 4 * size_t(texel[lane])), block);
        add_block(block, sum, lost);
    }
    return rgb_of(sum);
}

// Linear between the two texel centres of a ring that enclose u.
HWY_INLINE TexelVec along_ring(const RingLevel::Ring& ring, const float* texels, float u) {
    const TexelLanes dt;
    const float x = u * ring.texel_count + 0.5f;  // >= 0.5, so truncation is floor
    const int32_t column = int32_t(x);
    const float* left = texels + 4 * (ptrdiff_t(ring.first) + column - 1);
    const TexelVec a = hn::LoadU(dt, left);
    const TexelVec b = hn::LoadU(dt, left + 4);
    return hn::MulAdd(hn::Set(dt, x - float(column)), hn::Sub(b, a), a);
}

Vec3 RingSum(const RingLookups& lookups, const SampleSet& samples, const Frame& frame) {
    const FloatLanes d;
    const IntLanes di;
    const TexelLanes dt;
    HWY_ALIGN float u[SampleSet::padding];
    HWY_ALIGN float between[SampleSet::padding];
    HWY_ALIGN int32_t ring[SampleSet::padding];
    TexelVec sum = hn::Zero(dt), lost = hn::Zero(dt);
    for (size_t i = 0; i < samples.x.size(); i += hn::Lanes(d)) {
        const LatLongLanes at = lat_long_of(samples, i, frame);
        const Floats ring_count = hn::LoadU(d, &lookups.ring_count[i]);
        // Half a ring up to the centres, one down because rings[0] lies beyond the pole.
        const Floats y = hn::MulAdd(at.v, ring_count, hn::Set(d, 0.5f));
        const auto above = hn::ConvertTo(di, hn::Min(y, ring_count));
        hn::Store(at.u, d, u);
        hn::Store(above, di, ring);
        hn::Store(hn::Sub(y, hn::ConvertTo(d, above)), d, between);
        TexelVec block = hn::Zero(dt);
        for (size_t lane = 0; lane < hn::Lanes(d); ++lane) {
            const RingLevel& level = *lookups.level[i + lane];
            const RingLevel::Ring* rings = level.rings.data() + ring[lane];
            const TexelVec upper = along_ring(rings[0], level.texels.data(), u[lane]);
            const TexelVec lower = along_ring(rings[1], level.texels.data(), u[lane]);
            const TexelVec light =
                hn::MulAdd(hn::Set(dt, between[lane]), hn::Sub(lower, upper), upper);
            block = hn::MulAdd(hn::Set(dt, samples.weight[i + lane]), light, block);
        }
        add_block(block, sum, lost);
    }
    return rgb_of(sum);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace splitsum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splitsum {

HWY_EXPORT(TexelSum);
HWY_EXPORT(RingSum);

Frame frame_towards(const Vec3d& n, double angle) {
    const double azimuth = std::atan2(n.x, n.z);
    const Vec3d east(std::cos(azimuth), 0, -std::sin(azimuth));
    const Vec3d south = cross(n, east);
    const double c = std::cos(angle), s = std::sin(angle);
    return {Vec3(c * east + s * south), Vec3(c * south - s * east), Vec3(n)};
}

Vec3 sum_of_texels(const Environment& environment, const SampleSet& samples, const Frame& frame) {
    return HWY_DYNAMIC_DISPATCH(TexelSum)(environment, samples, frame);
}

Vec3 sum_of_rings(const RingLookups& lookups, const SampleSet& samples, const Frame& frame) {
    return HWY_DYNAMIC_DISPATCH(RingSum)(lookups, samples, frame);
}

}  // namespace splitsum
#endif  // HWY_ONCE
