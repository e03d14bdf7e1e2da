// Compiled once for each instruction set of this machine's family; the plain function at the end
// chooses among them at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "splitsum/table/half_vector_kernel.cpp"
#include "splitsum/table/half_vector_kernel.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cmath>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace splitsum {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<double, polar_padding>;
using Doubles = hn::Vec<Lanes>;

HWY_INLINE Doubles all(double value) { return hn::Set(Lanes(), value); }

// V of the height-correlated term, 0.5 / (n·l view_length + n·v light_length), as its denominator
// times u² for n·l times u²: the 0.5 is in `factor`.
struct HeightCorrelated {
    double n_dot_v, alpha2, view_length;
    double factor;

    HeightCorrelated(SmithTerm, double view, double alpha)
        : n_dot_v(view),
          alpha2(alpha * alpha),
          view_length(std::sqrt(view * view * (1 - alpha2) + alpha2)),
          factor(0.5) {}

    HWY_INLINE Doubles denominator(Doubles n_dot_l, Doubles u2) const {
        const Doubles squared = hn::MulAdd(hn::Mul(n_dot_l, n_dot_l), all(1 - alpha2),
                                           hn::Mul(all(alpha2), hn::Mul(u2, u2)));
        return hn::MulAdd(all(n_dot_v), hn::Sqrt(squared), hn::Mul(all(view_length), n_dot_l));
    }
};

// V of a Schlick term, 0.25 / ((n·l (1 - k) + k) (n·v (1 - k) + k)); the view's part is in `factor`.
struct Schlick {
    double k;
    double factor;

    Schlick(SmithTerm term, double view, double alpha)
        : k(schlick_k(term, alpha)), factor(0.25 / (view * (1 - k) + k)) {}

    HWY_INLINE Doubles denominator(Doubles n_dot_l, Doubles u2) const {
        return hn::MulAdd(n_dot_l, all(1 - k), hn::Mul(all(k), u2));
    }
};

// All polar nodes of one azimuth. The integrand for dtheta dphi is 4 D V (n·l) (v·h) sin theta. With
// p = tan(theta / 2) and u = 1 + p²: dtheta = 2 dp / u, sin theta = S / u, cos theta = C / u,
// v·h = H / u, n·l = N / u², D = alpha² u⁴ / (pi Q²), V = factor u² / E, so that all of it is
// 8 factor alpha² / pi times N H S u / (Q² E) dp, with a single division that gives 1 / u as well.
template <class Smith>
HWY_INLINE void add_azimuth(const Azimuth& at, double n_dot_v, double alpha2, const Smith& smith,
                            const PolarRule& rule, Doubles& albedo, Doubles& fresnel) {
    const Lanes d;
    const Doubles one = all(1), zero = hn::Zero(d);
    Doubles whole = zero, with_fresnel = zero;
    for (size_t i = 0; i < rule.nodes.size(); i += hn::Lanes(d)) {
        const Doubles p = hn::Mul(all(at.horizon), hn::LoadU(d, &rule.nodes[i]));
        const Doubles p2 = hn::Mul(p, p);
        const Doubles u = hn::Add(one, p2);
        const Doubles u2 = hn::Mul(u, u);
        const Doubles sine = hn::Add(p, p);
        const Doubles cosine = hn::Sub(one, p2);
        const Doubles v_dot_h = hn::MulAdd(all(at.across), sine, hn::Mul(all(n_dot_v), cosine));
        const Doubles n_dot_l = hn::Max(
            zero, hn::NegMulAdd(all(n_dot_v), u2, hn::Mul(hn::Add(v_dot_h, v_dot_h), cosine)));
        const Doubles slope = hn::MulAdd(hn::Mul(cosine, cosine), all(alpha2), hn::Mul(sine, sine));
        // At n·v = 0 the visibility of the horizon is 0 / 0 and weighs nothing.
        const Doubles below =
            hn::Max(hn::Mul(hn::Mul(slope, slope), smith.denominator(n_dot_l, u2)), all(1e-200));
        const Doubles quotient = hn::Div(one, hn::Mul(below, u));
        const Doubles inverse = hn::Mul(quotient, below);
        const Doubles above = hn::Mul(hn::Mul(n_dot_l, v_dot_h),
                                      hn::Mul(hn::Mul(sine, u2), hn::LoadU(d, &rule.weights[i])));
        const Doubles reflected = hn::Mul(above, quotient);
        const Doubles away = hn::NegMulAdd(v_dot_h, inverse, one);
        const Doubles away2 = hn::Mul(away, away);
        const Doubles schlick = hn::Mul(hn::Mul(away2, away2), away);
        whole = hn::Add(whole, reflected);
        with_fresnel = hn::MulAdd(schlick, reflected, with_fresnel);
    }
    const Doubles weight = all(at.weight * at.horizon);
    albedo = hn::MulAdd(weight, whole, albedo);
    fresnel = hn::MulAdd(weight, with_fresnel, fresnel);
}

template <class Smith>
SplitSum sum_azimuths(SmithTerm term, double alpha, const PolarRule& polar,
                      const AzimuthRule& azimuths) {
    const Lanes d;
    const double alpha2 = alpha * alpha;
    const Smith smith(term, azimuths.n_dot_v, alpha);
    Doubles albedo = hn::Zero(d), fresnel = albedo;
    for (const Azimuth& at : azimuths.azimuths)
        add_azimuth(at, azimuths.n_dot_v, alpha2, smith, polar, albedo, fresnel);
    const double factor = 8 * smith.factor * alpha2 * std::numbers::inv_pi;
    const double total = factor * hn::GetLane(hn::SumOfLanes(d, albedo));
    const double b = factor * hn::GetLane(hn::SumOfLanes(d, fresnel));
    return {total - b, b};
}

SplitSum Integrate(SmithTerm term, double alpha, const PolarRule& polar,
                   const AzimuthRule& azimuths) {
    return term == SmithTerm::height_correlated
               ? sum_azimuths<HeightCorrelated>(term, alpha, polar, azimuths)
               : sum_azimuths<Schlick>(term, alpha, polar, azimuths);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace splitsum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splitsum {

HWY_EXPORT(Integrate);

SplitSum integrate_half_vectors(SmithTerm term, double alpha, const PolarRule& polar,
                                const AzimuthRule& azimuths) {
    return HWY_DYNAMIC_DISPATCH(Integrate)(term, alpha, polar, azimuths);
}

}  // namespace splitsum
#endif  // HWY_ONCE
