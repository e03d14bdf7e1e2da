#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace splitsum {

// The only file that includes GLM: everyone else sees these names.
using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec2d = glm::dvec2;
using Vec3d = glm::dvec3;
using Mat3d = glm::dmat3;

using glm::cross;
using glm::dot;
using glm::length;
using glm::normalize;

/// Two tangents that complete a unit normal to a right-handed orthonormal frame.
/// Duff et al. 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1): no branch on small
/// components and exact to rounding for every unit `normal`.
struct Basis {
    Vec3d tangent;
    Vec3d bitangent;
    Vec3d normal;
};

inline Basis basis_around(const Vec3d& normal) {
    const double sign = std::copysign(1.0, normal.z);
    const double a = -1.0 / (sign + normal.z);
    const double b = normal.x * normal.y * a;
    return {Vec3d(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x),
            Vec3d(b, sign + normal.y * normal.y * a, -normal.y), normal};
}

}  // namespace splitsum
