// Compiled once for each instruction set of this machine's family; the plain functions at the end
// choose among them at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "splitsum/filter/line_kernels.cpp"
#include "splitsum/filter/line_kernels.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace splitsum {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Doubles = hn::ScalableTag<double>;
using HalfFloats = hn::Rebind<float, Doubles>;

void AddToLines(const float* values, size_t count, std::span<const float> weights,
                std::span<float* const> lines) {
    const Floats d;
    size_t i = 0;
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
        const auto value = hn::LoadU(d, values + i);
        for (size_t k = 0; k < lines.size(); ++k) {
            float* at = lines[k] + i;
            hn::StoreU(hn::MulAdd(hn::Set(d, weights[k]), value, hn::LoadU(d, at)), d, at);
        }
    }
    for (; i < count; ++i)
        for (size_t k = 0; k < lines.size(); ++k) lines[k][i] += weights[k] * values[i];
}

double SumOfSquares(const float* values, size_t count) {
    const Doubles d;
    auto even = hn::Zero(d), odd = hn::Zero(d);
    const auto load = [&](size_t i) HWY_ATTR {
        return hn::PromoteTo(d, hn::LoadU(HalfFloats(), values + i));
    };
    size_t i = 0;
    for (; i + 2 * hn::Lanes(d) <= count; i += 2 * hn::Lanes(d)) {
        const auto a = load(i), b = load(i + hn::Lanes(d));
        even = hn::MulAdd(a, a, even);
        odd = hn::MulAdd(b, b, odd);
    }
    double sum = hn::GetLane(hn::SumOfLanes(d, hn::Add(even, odd)));
    for (; i < count; ++i) sum += double(values[i]) * double(values[i]);
    return sum;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace splitsum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splitsum {

HWY_EXPORT(AddToLines);
HWY_EXPORT(SumOfSquares);

void add_to_lines(const float* values, size_t count, std::span<const float> weights,
                  std::span<float* const> lines) {
    HWY_DYNAMIC_DISPATCH(AddToLines)(values, count, weights, lines);
}

double sum_of_squares(const float* values, size_t count) {
    return HWY_DYNAMIC_DISPATCH(SumOfSquares)(values, count);
}

}  // namespace splitsum
#endif  // HWY_ONCE
