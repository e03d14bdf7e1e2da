#include "splitsum/atlas/exact_mirror.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "splitsum/base/parallel.h"

namespace splitsum {
namespace {

// Of a face; as many as its smallest texels need, which see the edges of rows at an angle of 0.
constexpr int lines_per_face = 16384;

// The point of the cube with corners (+-1, +-1, +-1): affine in s and t.
Vec3d cube_point(int face, double s, double t) {
    const Vec3d direction = direction_on_face(face, s, t);
    const Vec3d size = glm::abs(direction);
    return direction / std::max({size.x, size.y, size.z});
}

// The points start + s * step of a line across a face, along which y does not change.
struct Line {
    Vec3d start;
    Vec3d step;

    Vec3d at(double s) const { return start + s * step; }

    // An antiderivative in s of 1 / |at(s)|³, which is the solid angle over ds dt but for a factor.
    double solid_angle_to(double s) const {
        const Vec3d point = at(s);
        const double along = dot(start, step);
        const double distance2 = dot(start, start) * dot(step, step) - along * along;
        return dot(step, point) / (distance2 * length(point));
    }
};

/// Where lines leave one texel of the panorama for the next.
class Crossings {
public:
    explicit Crossings(int rows) {
        for (int column = 0; column < rows; ++column) {  // the opposite one lies in the same plane
            const double azimuth = std::numbers::pi * column / rows;
            planes_.emplace_back(std::cos(azimuth), 0, -std::sin(azimuth));
        }
        // Cones that open upwards and downwards by the same angle are one; the equator is a plane in
        // which no line crosses anything.
        for (int row = 1; 2 * row < rows; ++row)
            inverse_cosine2_.push_back(std::pow(std::cos(std::numbers::pi * row / rows), -2));
    }

    // The ends and all places between them, in order.
    void find(const Line& line, double first, double last, std::vector<double>& places) const {
        places.assign({first, last});
        const auto add = [&](double s) {
            if (s > first && s < last) places.push_back(s);
        };
        for (const Vec3d& normal : planes_)
            if (const double slope = dot(normal, line.step); slope != 0)
                add(-dot(normal, line.start) / slope);
        // On the cone |point|² = (y / cos theta)².
        const double a = dot(line.step, line.step), half_b = dot(line.start, line.step);
        for (const double inverse : inverse_cosine2_) {
            const double c = dot(line.start, line.start) - line.start.y * line.start.y * inverse;
            const double discriminant = half_b * half_b - a * c;
            if (discriminant < 0) continue;
            add((-half_b - std::sqrt(discriminant)) / a);
            add((-half_b + std::sqrt(discriminant)) / a);
        }
        std::ranges::sort(places);
    }

private:
    std::vector<Vec3d> planes_;
    std::vector<double> inverse_cosine2_;
};

Vec3 mean_over_texel(const Environment& environment, const Crossings& crossings, int face, int x,
                     int y, int face_size) {
    const Vec3d corner = cube_point(face, 0, 0);
    const Vec3d right = cube_point(face, 1, 0) - corner, down = cube_point(face, 0, 1) - corner;
    const double first = static_cast<double>(x) / face_size, last = (x + 1.0) / face_size;
    Vec3d sum(0);
    double total = 0;
    std::vector<double> places;
    const int lines_per_texel = std::max(1, lines_per_face / face_size);
    for (int i = 0; i < lines_per_texel; ++i) {
        const double t = (y + (i + 0.5) / lines_per_texel) / face_size;
        const Line line{corner + t * down, right};
        crossings.find(line, first, last, places);
        for (size_t k = 0; k + 1 < places.size(); ++k) {
            const double weight =
                line.solid_angle_to(places[k + 1]) - line.solid_angle_to(places[k]);
            const Vec3d middle = line.at(0.5 * (places[k] + places[k + 1]));
            sum += weight * Vec3d(radiance_towards(environment, middle));
            total += weight;
        }
    }
    return Vec3(sum / total);
}

}  // namespace

Result<Cubemap> exact_mirror(const Environment& environment, int face_size, Progress& progress) {
    Cubemap mirror(face_size);
    const Crossings crossings(environment.height());
    parallel_rows(face_count * face_size, [&](int row) {
        if (progress.cancelled()) return;
        const int face = row / face_size, y = row % face_size;
        for (int x = 0; x < face_size; ++x)
            mirror.at(face, x, y) = mean_over_texel(environment, crossings, face, x, y, face_size);
    });
    if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted while judging"};
    return mirror;
}

}  // namespace splitsum
