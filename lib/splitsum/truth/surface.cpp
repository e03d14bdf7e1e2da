#include "splitsum/truth/surface.h"

#include <algorithm>

namespace splitsum {
namespace {

constexpr double smallest_alpha = 1e-7;

Vec3d view_in(const Basis& frame, const Vec3d& view) {
    return normalize(Vec3d(dot(view, frame.tangent), dot(view, frame.bitangent),
                           std::max(dot(view, frame.normal), 0.0)));
}

}  // namespace

double alpha_of(const Material& material) {
    const double alpha = material.perceptual_roughness * material.perceptual_roughness;
    return alpha < smallest_alpha ? 0 : alpha;
}

Surface surface_of(const Material& material, const ViewSplitSum& split_sum, const Vec3d& normal,
                   const Vec3d& view) {
    const Basis frame = basis_around(normal);
    const Vec3d local = view_in(frame, view);
    const SplitSum of_view = split_sum.at(std::min(local.z, 1.0));
    return {alpha_of(material), frame, local,
            response_of(material.base_color, material.metalness, of_view)};
}

Vec3d mirrored_view(const Surface& surface) {
    const auto& [tangent, bitangent, normal] = surface.frame;
    const Vec3d& v = surface.view;
    return normal * v.z - tangent * v.x - bitangent * v.y;
}

}  // namespace splitsum
