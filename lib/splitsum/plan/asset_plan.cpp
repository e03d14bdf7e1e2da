#include "splitsum/plan/asset_plan.h"

#include <bit>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

constexpr int largest_face = 8192;
constexpr int most_samples = 1 << 24;
constexpr int highest_order = 128;

// `what` reads as the subject of the sentence: "the size of a cube face".
Status check_range(std::string_view what, int value, int lowest, int highest) {
    if (value >= lowest && value <= highest) return ok;
    return Error{ErrorKind::bad_argument,
                 cat(what, " must be from ", lowest, " to ", highest, ", got ", value)};
}

// KTX 2 and every graphics interface end a chain at the level whose faces are one texel.
int most_levels(int face_size) { return std::bit_width(static_cast<unsigned>(face_size)); }

Status check_levels(const SpecularPlan& plan) {
    if (plan.levels >= 1 && plan.levels <= most_levels(plan.face_size)) return ok;
    return Error{ErrorKind::bad_argument,
                 cat("a chain from faces of ", plan.face_size, " texels has 1 to ",
                     most_levels(plan.face_size), " levels, got ", plan.levels)};
}

Status check_curve(const SpecularPlan& plan) {
    if (const Status valid = validate(plan.roughness); !valid) return valid;
    const size_t values = plan.roughness.list.size();
    const bool is_list = plan.roughness.kind == RoughnessCurve::Kind::list;
    if (!is_list || values == static_cast<size_t>(plan.levels)) return ok;
    return Error{ErrorKind::bad_argument,
                 cat("the roughness list names ", values, " levels and the chain has ", plan.levels,
                     "; they must be equal")};
}

}  // namespace

Status validate(const FilterPlan& plan) {
    if (plan.method.empty())
        return Error{ErrorKind::bad_argument, "no filter method was named; the default is auto"};
    if (!(plan.accuracy >= 1e-5 && plan.accuracy <= 0.1))  // written so that NaN fails too
        return Error{ErrorKind::bad_argument,
                     cat("the accuracy must be from 1e-5 to 0.1, got ", plan.accuracy)};
    return check_range("the number of samples", plan.samples, 1, most_samples);
}

Status validate(const SpecularPlan& plan) {
    const Status size = check_range("the size of a cube face", plan.face_size, 1, largest_face);
    if (!size) return size;
    if (const Status levels = check_levels(plan); !levels) return levels;
    return check_curve(plan);
}

Status validate(const IrradiancePlan& plan) {
    const Status size = check_range("the size of a cube face", plan.face_size, 1, largest_face);
    if (!size) return size;
    return check_range("the order of the harmonics", plan.harmonics_order, 0, highest_order);
}

}  // namespace splitsum
