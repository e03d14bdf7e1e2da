// Compiled once for each instruction set of this machine's family; the plain functions at the end
// choose among them at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "splitsum/filter/legendre_kernels.cpp"
#include "splitsum/filter/legendre_kernels.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace splitsum {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<double, theta_padding>;
using FloatLanes = hn::Rebind<float, Lanes>;
using Doubles = hn::Vec<Lanes>;

// start * sine^m by squaring; underflows to 0 where every P_lm of interest is negligible.
HWY_INLINE Doubles first_value(double start, Doubles sine, int m) {
    const Lanes d;
    Doubles power = hn::Set(d, start);
    for (unsigned bits = unsigned(m); bits != 0; bits >>= 1) {
        if (bits & 1) power = hn::Mul(power, sine);
        sine = hn::Mul(sine, sine);
    }
    return power;
}

HWY_INLINE Doubles load_floats(const float* from) {
    return hn::PromoteTo(Lanes(), hn::LoadU(FloatLanes(), from));
}

// The state of the recurrence at every point of every row: P_l and P_(l-1).
struct Recurrence {
    std::vector<double> current, previous;
};

Recurrence start_recurrence(const LegendreOrder& order, const LegendreRows& rows) {
    const Lanes d;
    Recurrence state{std::vector<double>(rows.cosine.size()),
                     std::vector<double>(rows.cosine.size())};
    for (size_t i = 0; i < rows.sine.size(); i += hn::Lanes(d))
        hn::StoreU(first_value(order.start, hn::LoadU(d, &rows.sine[i]), order.m), d,
                   &state.current[i]);
    return state;
}

// A step of the recurrence from degree l - 1 to l; zeros past the last one.
struct Step {
    Doubles a, b;
};

HWY_INLINE Step step_to(const LegendreOrder& order, size_t k) {
    const Lanes d;
    const bool exists = k < order.a.size();
    return {hn::Set(d, exists ? order.a[k] : 0), hn::Set(d, exists ? order.b[k] : 0)};
}

// The integrals over lanes of rows of one degree, times three channels, real and imaginary.
struct Integrals {
    Doubles v0, v1, v2, v3, v4, v5;

    HWY_INLINE void add(const float* values, size_t stride, Doubles over_row) {
        v0 = hn::MulAdd(load_floats(values), over_row, v0);
        v1 = hn::MulAdd(load_floats(values + stride), over_row, v1);
        v2 = hn::MulAdd(load_floats(values + 2 * stride), over_row, v2);
        v3 = hn::MulAdd(load_floats(values + 3 * stride), over_row, v3);
        v4 = hn::MulAdd(load_floats(values + 4 * stride), over_row, v4);
        v5 = hn::MulAdd(load_floats(values + 5 * stride), over_row, v5);
    }

    HWY_INLINE void store(double* out) const {
        const Lanes d;
        const Doubles sums[complex_rgb] = {v0, v1, v2, v3, v4, v5};
        for (size_t c = 0; c < complex_rgb; ++c) out[c] = hn::GetLane(hn::SumOfLanes(d, sums[c]));
    }
};

// Two degrees at a time, so that the recurrence's state is read and written half as often.
void IntegrateOrder(const LegendreOrder& order, int bands, const LegendreRows& rows,
                    size_t first_row, const float* even, const float* odd, double* out) {
    const Lanes d;
    const Doubles zero = hn::Zero(d);
    Recurrence state = start_recurrence(order, rows);
    const size_t degrees = size_t(bands - order.m);
    for (size_t k = 0; k < degrees; k += 2) {
        const Step first = step_to(order, k + 1), second = step_to(order, k + 2);
        Integrals evens{zero, zero, zero, zero, zero, zero}, odds = evens;
        for (size_t row = first_row; row < rows.rows; row += hn::Lanes(d)) {
            Doubles over_even = zero, over_odd = zero;
            for (size_t point = 0; point < rows.points; ++point) {
                const size_t i = point * rows.rows + row;
                const Doubles x = hn::LoadU(d, &rows.cosine[i]);
                const Doubles weight = hn::LoadU(d, &rows.weight[i]);
                const Doubles p = hn::LoadU(d, &state.current[i]);
                const Doubles before = hn::Mul(first.b, hn::LoadU(d, &state.previous[i]));
                const Doubles next = hn::Mul(first.a, hn::MulSub(x, p, before));
                over_even = hn::MulAdd(weight, p, over_even);
                over_odd = hn::MulAdd(weight, next, over_odd);
                const Doubles after = hn::MulSub(x, next, hn::Mul(second.b, p));
                hn::StoreU(next, d, &state.previous[i]);
                hn::StoreU(hn::Mul(second.a, after), d, &state.current[i]);
            }
            evens.add(even + row, rows.rows, over_even);
            odds.add(odd + row, rows.rows, over_odd);
        }
        evens.store(out + k * complex_rgb);
        if (k + 1 < degrees) odds.store(out + (k + 1) * complex_rgb);
    }
}

// Accumulators of one vector of angles: three channels, real and imaginary.
struct Six {
    Doubles v0, v1, v2, v3, v4, v5;
};

HWY_INLINE void add_scaled(Six& sum, const double* coefficients, Doubles p) {
    const Lanes d;
    sum.v0 = hn::MulAdd(hn::Set(d, coefficients[0]), p, sum.v0);
    sum.v1 = hn::MulAdd(hn::Set(d, coefficients[1]), p, sum.v1);
    sum.v2 = hn::MulAdd(hn::Set(d, coefficients[2]), p, sum.v2);
    sum.v3 = hn::MulAdd(hn::Set(d, coefficients[3]), p, sum.v3);
    sum.v4 = hn::MulAdd(hn::Set(d, coefficients[4]), p, sum.v4);
    sum.v5 = hn::MulAdd(hn::Set(d, coefficients[5]), p, sum.v5);
}

HWY_INLINE void store(const Six& sum, float* out, size_t stride) {
    const FloatLanes df;
    hn::StoreU(hn::DemoteTo(df, sum.v0), df, out);
    hn::StoreU(hn::DemoteTo(df, sum.v1), df, out + stride);
    hn::StoreU(hn::DemoteTo(df, sum.v2), df, out + 2 * stride);
    hn::StoreU(hn::DemoteTo(df, sum.v3), df, out + 3 * stride);
    hn::StoreU(hn::DemoteTo(df, sum.v4), df, out + 4 * stride);
    hn::StoreU(hn::DemoteTo(df, sum.v5), df, out + 5 * stride);
}

void SumOrder(const LegendreOrder& order, int bands, std::span<const double> cosine,
              std::span<const double> sine, size_t first, const double* coefficients, float* even,
              float* odd) {
    const Lanes d;
    const Doubles zero = hn::Zero(d);
    const size_t degrees = size_t(bands - order.m);
    for (size_t j = first; j < cosine.size(); j += hn::Lanes(d)) {
        const Doubles x = hn::LoadU(d, &cosine[j]);
        Doubles p = first_value(order.start, hn::LoadU(d, &sine[j]), order.m), previous = zero;
        Six sum_even{zero, zero, zero, zero, zero, zero}, sum_odd = sum_even;
        const auto advance = [&](size_t k) HWY_ATTR {  // P_(m+k) from the two before it
            const Doubles before = hn::Mul(hn::Set(d, order.b[k]), previous);
            previous = p;
            p = hn::Mul(hn::Set(d, order.a[k]), hn::MulSub(x, p, before));
        };
        size_t k = 0;
        for (; k + 1 < degrees; k += 2) {
            if (k > 0) advance(k);
            add_scaled(sum_even, coefficients + k * complex_rgb, p);
            advance(k + 1);
            add_scaled(sum_odd, coefficients + (k + 1) * complex_rgb, p);
        }
        if (k < degrees) {
            if (k > 0) advance(k);
            add_scaled(sum_even, coefficients + k * complex_rgb, p);
        }
        store(sum_even, even + j, cosine.size());
        store(sum_odd, odd + j, cosine.size());
    }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace splitsum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splitsum {

HWY_EXPORT(IntegrateOrder);
HWY_EXPORT(SumOrder);

LegendreOrder::LegendreOrder(int order, int bands) : m(order) {
    // P_mm = sqrt((2m + 1)!! / (2m)!! / (4 pi)) sin^m theta.
    double squared = 1 / (4 * std::numbers::pi);
    for (int i = 1; i <= m; ++i) squared *= (2 * i + 1.0) / (2 * i);
    start = std::sqrt(squared);
    const double m2 = double(m) * m;
    for (int l = m; l < bands; ++l) {
        const double l2 = double(l) * l, before2 = double(l - 1) * (l - 1);
        a.push_back(l == m ? 0 : std::sqrt((4 * l2 - 1) / (l2 - m2)));
        b.push_back(l <= m + 1 ? 0 : std::sqrt((before2 - m2) / (4 * before2 - 1)));
    }
}

size_t first_relevant_angle(int m, int bands, std::span<const double> sines) {
    const double margin = 10 * std::cbrt(0.5 * m);
    size_t first = 0;
    while (first < sines.size() && sines[first] * (bands + 0.5) < m - margin) ++first;
    return first / theta_padding * theta_padding;
}

void integrate_order(const LegendreOrder& order, int bands, const LegendreRows& rows,
                     size_t first_row, const float* even, const float* odd, double* out) {
    HWY_DYNAMIC_DISPATCH(IntegrateOrder)(order, bands, rows, first_row, even, odd, out);
}

void sum_order(const LegendreOrder& order, int bands, std::span<const double> cosine,
               std::span<const double> sine, size_t first, const double* coefficients, float* even,
               float* odd) {
    HWY_DYNAMIC_DISPATCH(SumOrder)(order, bands, cosine, sine, first, coefficients, even, odd);
}

}  // namespace splitsum
#endif  // HWY_ONCE
