#include "splitsum/brdf/smith.h"

#include <array>
#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

constexpr std::array<SmithTermInfo, 3> terms = {{
    {SmithTerm::height_correlated, "height-correlated",
     "height-correlated Smith (Heitz 2014), the exact term of a GGX surface"},
    {SmithTerm::schlick_half, "schlick-half",
     "separable Schlick-Smith with k = alpha / 2 (Karis 2013)"},
    {SmithTerm::schlick_sqrt, "schlick-sqrt",
     "separable Schlick-Smith with k = alpha sqrt(2 / pi) (Schlick 1994)"},
}};

double height_correlated_visibility(double n_dot_l, double n_dot_v, double alpha) {
    const double alpha2 = alpha * alpha;
    const double view_part = n_dot_l * std::sqrt(n_dot_v * n_dot_v * (1 - alpha2) + alpha2);
    const double light_part = n_dot_v * std::sqrt(n_dot_l * n_dot_l * (1 - alpha2) + alpha2);
    return 0.5 / (view_part + light_part);
}

double schlick_visibility(double n_dot_l, double n_dot_v, double k) {
    return 0.25 / ((n_dot_l * (1 - k) + k) * (n_dot_v * (1 - k) + k));
}

}  // namespace

std::span<const SmithTermInfo> smith_terms() { return terms; }

const SmithTermInfo& info_of(SmithTerm term) {
    for (const SmithTermInfo& info : terms)
        if (info.term == term) return info;
    return terms.front();
}

double smith_masking(double cosine, double alpha) {
    const double alpha2 = alpha * alpha;
    return 2 * cosine / (cosine + std::sqrt(cosine * cosine * (1 - alpha2) + alpha2));
}

double schlick_k(SmithTerm term, double alpha) {
    constexpr double sqrt_two_over_pi = std::numbers::sqrt2 * std::numbers::inv_sqrtpi;
    return term == SmithTerm::schlick_half ? 0.5 * alpha : sqrt_two_over_pi * alpha;
}

double smith_visibility(SmithTerm term, double n_dot_l, double n_dot_v, double alpha) {
    if (term == SmithTerm::height_correlated)
        return height_correlated_visibility(n_dot_l, n_dot_v, alpha);
    return schlick_visibility(n_dot_l, n_dot_v, schlick_k(term, alpha));
}

}  // namespace splitsum
