#include "splitsum/ltc/target_lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/brdf/disney_diffuse.h"
#include "splitsum/brdf/ggx.h"
#include "splitsum/brdf/lambert.h"
#include "splitsum/brdf/smith.h"
#include "splitsum/brdf/visible_normals.h"
#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

Vec3d view_at(double n_dot_v) {
    const double cosine = std::max(n_dot_v, TargetLobe::most_grazing);
    return {std::sqrt((1 - cosine) * (1 + cosine)), 0, cosine};
}

}  // namespace

TargetLobe::TargetLobe(LtcTarget target, double n_dot_v, double perceptual_roughness)
    : target_(target),
      perceptual_roughness_(std::max(perceptual_roughness, smoothest)),
      alpha_(perceptual_roughness_ * perceptual_roughness_),
      view_(view_at(n_dot_v)) {
    double sum = 0;
    for (const LobeNode& node : nodes(nodes_for_albedo)) sum += 2 * node.weight * value(node.light);
    albedo_ = sum;
}

double TargetLobe::density(const Vec3d& light) const { return value(light) / albedo_; }

double TargetLobe::value(const Vec3d& light) const {
    if (light.z <= 0) return 0;
    if (target_ == LtcTarget::disney_diffuse)
        return light.z * disney_diffuse(DisneyDiffuse::burley, light.z, view_.z, dot(light, view_),
                                        perceptual_roughness_);
    const Vec3d half = normalize(light + view_);
    return ggx_density(half.x * half.x + half.y * half.y, alpha_) *
           smith_visibility(SmithTerm::height_correlated, light.z, view_.z, alpha_) * light.z;
}

// The density of visible normals over the 4 v·h of the reflection.
double TargetLobe::sampling_pdf(const Vec3d& light) const {
    if (target_ == LtcTarget::disney_diffuse) return cosine_direction_pdf(light.z);
    if (light.z <= 0) return 0;
    const Vec3d half = normalize(light + view_);
    return smith_masking(view_.z, alpha_) * ggx_density(half.x * half.x + half.y * half.y, alpha_) /
           (4 * view_.z);
}

std::vector<LobeNode> TargetLobe::nodes(int count) const {
    const QuadratureRule rule = gauss_legendre(count);
    std::vector<LobeNode> found;
    found.reserve(static_cast<size_t>(count) * static_cast<size_t>(count));
    for (size_t i = 0; i < rule.nodes.size(); ++i)
        for (size_t j = 0; j < rule.nodes.size(); ++j) {
            // The second coordinate is the azimuth in turns: half of it is the half y >= 0.
            const Vec2d u{0.5 * (1 + rule.nodes[i]), 0.25 * (1 + rule.nodes[j])};
            Vec3d light;
            if (target_ == LtcTarget::ggx) {
                const Vec3d half = sample_visible_normal(view_, u, alpha_);
                light = 2 * dot(view_, half) * half - view_;
            } else {
                light = sample_cosine_direction(u);
            }
            const double pdf = sampling_pdf(light);
            if (pdf > 0) found.push_back({light, 0.125 * rule.weights[i] * rule.weights[j] / pdf});
        }
    return found;
}

}  // namespace splitsum
