#include "splitsum/brdf/charlie.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

constexpr std::array<ClothVisibilityInfo, 3> infos = {{
    {ClothVisibility::neubelt, "neubelt",
     "1 / (4 (n.l + n.v - n.l n.v)) (Neubelt & Pettineo 2013), as in Filament"},
    {ClothVisibility::neubelt_clamped, "neubelt-clamped",
     "the same, at most 1, as shaders of three.js and Khronos compute it"},
    {ClothVisibility::estevez_kulla, "estevez-kulla",
     "the fitted Smith term of Estevez & Kulla 2017, first choice of KHR_materials_sheen"},
}};

// a / (1 + b x^c) + d x + e: table 1 of the paper, for alpha = 0 and alpha = 1.
struct LambdaFit {
    double a, b, c, d, e;
};
constexpr LambdaFit fit_at_0 = {25.3245, 3.32435, 0.16801, -1.27393, -4.85967};
constexpr LambdaFit fit_at_1 = {21.5473, 3.82987, 0.19823, -1.97760, -4.32054};

double log_lambda(double cosine, double alpha) {
    const double share = (1 - alpha) * (1 - alpha);
    const auto mix = [&](double at_0, double at_1) { return share * at_0 + (1 - share) * at_1; };
    return mix(fit_at_0.a, fit_at_1.a) /
               (1 + mix(fit_at_0.b, fit_at_1.b) * std::pow(cosine, mix(fit_at_0.c, fit_at_1.c))) +
           mix(fit_at_0.d, fit_at_1.d) * cosine + mix(fit_at_0.e, fit_at_1.e);
}

double neubelt(double n_dot_l, double n_dot_v) {
    return 0.25 / (n_dot_l + n_dot_v * (1 - n_dot_l));
}

}  // namespace

double charlie_density(double sin2_theta, double alpha) {
    const double inverse = 1 / alpha;
    return (2 + inverse) * std::pow(sin2_theta, 0.5 * inverse) * 0.5 * std::numbers::inv_pi;
}

std::span<const ClothVisibilityInfo> cloth_visibilities() { return infos; }

// The paper fits one half of the range and mirrors it, in the logarithm, about a cosine of 1/2.
double charlie_lambda(double cosine, double alpha) {
    if (cosine < 0.5) return std::exp(log_lambda(cosine, alpha));
    return std::exp(2 * log_lambda(0.5, alpha) - log_lambda(1 - cosine, alpha));
}

double cloth_visibility(ClothVisibility visibility, double n_dot_l, double n_dot_v, double alpha) {
    if (visibility == ClothVisibility::neubelt) return neubelt(n_dot_l, n_dot_v);
    if (visibility == ClothVisibility::neubelt_clamped)
        return std::min(1.0, neubelt(n_dot_l, n_dot_v));
    return 0.25 / (n_dot_l * n_dot_v *
                   (1 + charlie_lambda(n_dot_l, alpha) + charlie_lambda(n_dot_v, alpha)));
}

}  // namespace splitsum
