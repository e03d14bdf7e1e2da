#include "splitsum/truth/unsplit_brdf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/brdf/ggx.h"
#include "splitsum/brdf/smith.h"

namespace splitsum {
namespace {

// G1 / (4 cosine) in the form that is finite at cosine = 0 (smith_masking).
double quarter_masking(double cosine, double alpha) {
    const double alpha2 = alpha * alpha;
    return 0.5 / (cosine + std::sqrt(cosine * cosine * (1 - alpha2) + alpha2));
}

double fifth_power(double x) { return x * x * (x * x) * x; }

}  // namespace

UnsplitBrdf::UnsplitBrdf(double alpha, const Vec3d& view, const SurfaceResponse& response)
    : alpha_(alpha),
      view_(view),
      f0_(response.f0),
      compensation_(response.compensation),
      diffuse_(response.diffuse_albedo * std::numbers::inv_pi),
      seen_share_(alpha > 0 ? quarter_masking(view.z, alpha) : 0) {}

UnsplitBrdf::Value UnsplitBrdf::towards(const Vec3d& light, const Vec3d& half) const {
    if (light.z <= 0) return {};
    Value value{diffuse_ * light.z, 0, is_diffuse() ? light.z * std::numbers::inv_pi : 0};
    if (alpha_ == 0) return value;
    const double density = ggx_density(std::min(half.x * half.x + half.y * half.y, 1.0), alpha_);
    const double visibility =
        smith_visibility(SmithTerm::height_correlated, light.z, view_.z, alpha_);
    const Vec3d fresnel = f0_ + fifth_power(std::max(1 - dot(view_, half), 0.0)) * (Vec3d(1) - f0_);
    value.reflected += density * visibility * light.z * compensation_ * fresnel;
    // D v·h G1(v) / n·v of the normal, over the 4 v·h that reflection stretches angles by.
    value.lobe_pdf = density * seen_share_;
    return value;
}

}  // namespace splitsum
