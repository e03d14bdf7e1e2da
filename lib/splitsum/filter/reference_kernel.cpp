// Compiled once for each instruction set of this machine's family; the plain function at the end
// chooses among them at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "splitsum/filter/reference_kernel.cpp"
#include "splitsum/filter/reference_kernel.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace splitsum {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// At a texel's four points.
template <class V>
using Cosines = V[2][2];

template <class V>
struct Fraction {
    V top;
    V bottom;
};

template <class V>
HWY_INLINE Fraction<V> sum_of(const Fraction<V>& a, const Fraction<V>& b) {
    return {hn::MulAdd(a.top, b.bottom, hn::Mul(b.top, a.bottom)), hn::Mul(a.bottom, b.bottom)};
}

// lobe_value() of GGX over lanes, without its factor alpha² / pi.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Fraction<V> ggx_lanes(D d, double alpha2, V cosine) {
    const V sin2 = hn::NegMulAdd(hn::Set(d, 0.5), cosine, hn::Set(d, 0.5));
    const V denominator = hn::MulAdd(sin2, hn::Set(d, 1 - alpha2), hn::Set(d, alpha2));
    return {hn::Max(cosine, hn::Zero(d)), hn::Mul(denominator, denominator)};
}

// The sum over a texel's points of weight * lobe value. Divisions take most of the time of GGX: the
// four fractions are added before the only one. Denominators of points that may be summed so are
// above 1e-8 (half the squared distance from the peak), their product above 1e-64.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V texel_weight(D d, const Lobe& lobe, const TexelNodes& nodes,
                          const Cosines<V>& cosine) {
    const V weight0 = hn::Set(d, nodes.weights[0]), weight1 = hn::Set(d, nodes.weights[1]);
    if (lobe.kind == LobeKind::cosine) {
        const auto both = [&](const V(&of)[2]) HWY_ATTR {
            return hn::Add(hn::Max(of[0], hn::Zero(d)), hn::Max(of[1], hn::Zero(d)));
        };
        return hn::MulAdd(weight0, both(cosine[0]), hn::Mul(weight1, both(cosine[1])));
    }
    const double alpha2 = lobe.alpha * lobe.alpha;
    const auto both = [&](const V(&of)[2]) HWY_ATTR {
        return sum_of(ggx_lanes(d, alpha2, of[0]), ggx_lanes(d, alpha2, of[1]));
    };
    Fraction<V> row0 = both(cosine[0]), row1 = both(cosine[1]);
    row0.top = hn::Mul(row0.top, weight0);
    row1.top = hn::Mul(row1.top, weight1);
    const Fraction<V> all = sum_of(row0, row1);
    return hn::Mul(hn::Set(d, alpha2 * std::numbers::inv_pi), hn::Div(all.top, all.bottom));
}

// The radiance of the next texels, one a lane.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE void load_texels(DF df, const TexelRun& run, size_t i, VF& r, VF& g, VF& b) {
    VF unused;
    if (run.floats_per_texel == 3)
        hn::LoadInterleaved3(df, run.texels + 3 * i, r, g, b);
    else
        hn::LoadInterleaved4(df, run.texels + 4 * i, r, g, b, unused);
}

// Adds texels [begin, end) to the sums of the three channels, Lanes(d) at a time; returns where it
// stopped because fewer were left.
template <class D>
HWY_INLINE size_t add_run(D d, const Lobe& lobe, const TexelRun& run, const TexelNodes& nodes,
                          size_t begin, Vec3d& sum) {
    using V = hn::Vec<D>;
    const hn::Rebind<float, D> df;
    V red = hn::Zero(d), green = hn::Zero(d), blue = hn::Zero(d);
    size_t i = begin;
    for (; i + hn::Lanes(d) <= run.count; i += hn::Lanes(d)) {
        const V sine = hn::LoadU(d, run.sin_azimuth + i);
        const V cosine_azimuth = hn::LoadU(d, run.cos_azimuth + i);
        Cosines<V> cosine;
        for (size_t n = 0; n < 2; ++n)
            for (size_t k = 0; k < 2; ++k) {
                const TexelNode& node = nodes.nodes[n][k];
                cosine[n][k] = hn::MulAdd(
                    hn::Set(d, node.along_cos), cosine_azimuth,
                    hn::MulAdd(hn::Set(d, node.along_sin), sine, hn::Set(d, node.constant)));
            }
        const V weight = texel_weight(d, lobe, nodes, cosine);
        hn::Vec<decltype(df)> r, g, b;
        load_texels(df, run, i, r, g, b);
        red = hn::MulAdd(weight, hn::PromoteTo(d, r), red);
        green = hn::MulAdd(weight, hn::PromoteTo(d, g), green);
        blue = hn::MulAdd(weight, hn::PromoteTo(d, b), blue);
    }
    const auto total = [&](auto lanes) HWY_ATTR { return hn::GetLane(hn::SumOfLanes(d, lanes)); };
    sum += Vec3d(total(red), total(green), total(blue));
    return i;
}

Vec3d RunSum(const Lobe& lobe, const TexelRun& run, const TexelNodes& nodes) {
    Vec3d sum(0);
    const size_t rest = add_run(hn::ScalableTag<double>(), lobe, run, nodes, 0, sum);
    add_run(hn::CappedTag<double, 1>(), lobe, run, nodes, rest, sum);
    return sum;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace splitsum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splitsum {

HWY_EXPORT(RunSum);

Vec3d sum_of_run(const Lobe& lobe, const TexelRun& run, const TexelNodes& nodes) {
    return HWY_DYNAMIC_DISPATCH(RunSum)(lobe, run, nodes);
}

}  // namespace splitsum
#endif  // HWY_ONCE
