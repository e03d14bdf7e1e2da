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

// lobe_value() over lanes, as a function of the cosine.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V lobe_lanes(D d, const Lobe& lobe, V cosine) {
    const V clamped = hn::Max(cosine, hn::Zero(d));
    if (lobe.kind == LobeKind::cosine) return clamped;
    const double alpha2 = lobe.alpha * lobe.alpha;
    const V sin2 = hn::NegMulAdd(hn::Set(d, 0.5), cosine, hn::Set(d, 0.5));
    const V denominator = hn::MulAdd(sin2, hn::Set(d, 1 - alpha2), hn::Set(d, alpha2));
    const V numerator = hn::Mul(clamped, hn::Set(d, alpha2 * std::numbers::inv_pi));
    return hn::Div(numerator, hn::Mul(denominator, denominator));
}

// Adds texels [begin, end) to the sums of the three channels, Lanes(d) at a time; returns where it
// stopped because fewer were left.
template <class D>
HWY_INLINE size_t add_run(D d, const Lobe& lobe, const TexelRun& run,
                          const std::array<RowNode, 2>& nodes, size_t begin, Vec3d& sum) {
    const hn::Rebind<float, D> df;
    auto red = hn::Zero(d), green = hn::Zero(d), blue = hn::Zero(d);
    size_t i = begin;
    for (; i + hn::Lanes(d) <= run.count; i += hn::Lanes(d)) {
        auto weight = hn::Zero(d);
        for (const RowNode& node : nodes)
            for (size_t k = 0; k < 2; ++k) {
                const auto sine = hn::LoadU(d, run.sin_azimuth[k] + i);
                const auto cosine = hn::LoadU(d, run.cos_azimuth[k] + i);
                const auto towards = hn::MulAdd(
                    hn::Set(d, node.along_cos), cosine,
                    hn::MulAdd(hn::Set(d, node.along_sin), sine, hn::Set(d, node.constant)));
                weight = hn::MulAdd(hn::Set(d, node.weight), lobe_lanes(d, lobe, towards), weight);
            }
        hn::Vec<decltype(df)> r, g, b, unused;
        hn::LoadInterleaved4(df, run.texels + 4 * i, r, g, b, unused);
        red = hn::MulAdd(weight, hn::PromoteTo(d, r), red);
        green = hn::MulAdd(weight, hn::PromoteTo(d, g), green);
        blue = hn::MulAdd(weight, hn::PromoteTo(d, b), blue);
    }
    const auto total = [&](auto lanes) HWY_ATTR { return hn::GetLane(hn::SumOfLanes(d, lanes)); };
    sum += Vec3d(total(red), total(green), total(blue));
    return i;
}

Vec3d RunSum(const Lobe& lobe, const TexelRun& run, const std::array<RowNode, 2>& nodes) {
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

Vec3d sum_of_run(const Lobe& lobe, const TexelRun& run, const std::array<RowNode, 2>& nodes) {
    return HWY_DYNAMIC_DISPATCH(RunSum)(lobe, run, nodes);
}

}  // namespace splitsum
#endif  // HWY_ONCE
