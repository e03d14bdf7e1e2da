#include "splitsum/ltc/polygon_reference.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "splitsum/brdf/polygon.h"
#include "splitsum/math/quadrature.h"

namespace splitsum {
namespace {

using Polygon = std::vector<Vec3d>;

constexpr double least_width =
    0.02;  // of a grazing lobe across the plane of reflection, over alpha
constexpr int deepest = 14;

// Directions turned so that the mirror direction is +z, and divided by the lobe's widths.
class Stretch {
public:
    explicit Stretch(const TargetLobe& lobe) {
        if (lobe.target() != LtcTarget::ggx) return;
        cosine_ = lobe.view().z;
        sine_ = lobe.view().x;
        width_x_ = std::min(1.0, 2 * lobe.alpha());
        width_y_ = std::min(1.0, 2 * lobe.alpha() * std::max(cosine_, least_width));
    }

    Vec3d there(const Vec3d& d) const {
        return {(d.x * cosine_ + d.z * sine_) / width_x_, d.y / width_y_,
                d.z * cosine_ - d.x * sine_};
    }
    Vec3d back(const Vec3d& w) const {
        const double x = w.x * width_x_;
        return {x * cosine_ - w.z * sine_, w.y * width_y_, x * sine_ + w.z * cosine_};
    }
    double determinant() const { return width_x_ * width_y_; }

private:
    double cosine_ = 1, sine_ = 0, width_x_ = 1, width_y_ = 1;
};

// The part of a polygon where dot(side, x) > 0.
Polygon clipped(const Polygon& polygon, const Vec3d& side) {
    Polygon kept;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d& from = polygon[i];
        const Vec3d& to = polygon[(i + 1) % polygon.size()];
        const double a = dot(side, from), b = dot(side, to);
        if (a > 0) kept.push_back(from);
        if ((a > 0) != (b > 0)) kept.push_back(from + a / (a - b) * (to - from));
    }
    return kept;
}

// What lies in the pyramid over one face of the cube, projected onto the face.
Polygon on_cube_face(Polygon polygon, int axis, double sign) {
    Vec3d normal(0);
    normal[axis] = sign;
    for (int other = (axis + 1) % 3; other != axis; other = (other + 1) % 3)
        for (const double side : {-1.0, 1.0}) {
            Vec3d plane = normal;
            plane[other] = side;
            polygon = clipped(polygon, plane);
        }
    for (Vec3d& corner : polygon) corner /= dot(corner, normal);
    return polygon;
}

class Integral {
public:
    Integral(const TargetLobe& lobe, double tolerance)
        : lobe_(lobe), stretch_(lobe), tolerance_(tolerance) {}

    double over(std::span<const Vec3d> polygon) const {
        Polygon stretched;
        for (const Vec3d& corner : clip_to_horizon(polygon))
            stretched.push_back(normalize(stretch_.there(corner)));
        double sum = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {-1.0, 1.0}) {
                const Polygon face = on_cube_face(stretched, axis, sign);
                for (size_t i = 2; i < face.size(); ++i)
                    sum += over_triangle(face[0], face[i - 1], face[i], tolerance_, 0);
            }
        return sum;
    }

private:
    // In stretched space, dl = determinant |w|³ / |l|³ dw, and dw = height dA / |w|³ on a triangle.
    double by_rule(const QuadratureRule& rule, const Vec3d& a, const Vec3d& b,
                   const Vec3d& c) const {
        const double volume = std::abs(dot(a, cross(b, c)));
        return volume * stretch_.determinant() * integrate(rule, 0, 1, [&](double u) {
                   return u * integrate(rule, 0, 1, [&](double v) {
                              const Vec3d l =
                                  stretch_.back(a + u * ((1 - v) * (b - a) + v * (c - a)));
                              const double distance = length(l);
                              return lobe_.value(l / distance) / (distance * distance * distance);
                          });
               });
    }

    double over_triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, double tolerance,
                         int depth) const {
        const double fine = by_rule(fine_, a, b, c);
        if (depth == deepest ||
            (depth > 0 && std::abs(fine - by_rule(coarse_, a, b, c)) < tolerance))
            return fine;
        const Vec3d ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
        return over_triangle(a, ab, ca, 0.5 * tolerance, depth + 1) +
               over_triangle(ab, b, bc, 0.5 * tolerance, depth + 1) +
               over_triangle(ca, bc, c, 0.5 * tolerance, depth + 1) +
               over_triangle(ab, bc, ca, 0.5 * tolerance, depth + 1);
    }

    const TargetLobe& lobe_;
    Stretch stretch_;
    double tolerance_;
    QuadratureRule coarse_ = gauss_legendre(6);
    QuadratureRule fine_ = gauss_legendre(10);
};

}  // namespace

double polygon_light_reference(const TargetLobe& lobe, std::span<const Vec3d> polygon,
                               double tolerance) {
    return Integral(lobe, tolerance).over(polygon);
}

}  // namespace splitsum
