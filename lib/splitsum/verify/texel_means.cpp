#include "splitsum/verify/texel_means.h"

#include <algorithm>
#include <cmath>

#include "splitsum/base/parallel.h"
#include "splitsum/math/low_discrepancy.h"
#include "splitsum/sphere/cubemap.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

TexelMeans::TexelMeans(int height, const Mat3d& panorama_from_cube,
                       const std::vector<CubeTexel>& texels)
    : height_(height), means_(texels.size()) {
    parallel_rows(int(texels.size()), [&](int i) {
        Mean& mean = means_[size_t(i)];
        mean.points = points_of(texels[size_t(i)], panorama_from_cube);
        for (const Point& point : mean.points) mean.total += point.weight;
    });
}

std::vector<TexelMeans::Point> TexelMeans::points_of(const CubeTexel& texel,
                                                     const Mat3d& panorama_from_cube) const {
    // Not a grid, of which an edge of a sun that runs along it would take or leave a whole row.
    constexpr uint32_t count = 128 * 128;
    const auto place = [](double share, int cells) {
        return std::clamp(int(share * cells), 0, cells - 1);
    };
    std::vector<Point> points;
    points.reserve(count);
    for (uint32_t i = 0; i < count; ++i) {
        const Vec2d within = hammersley(i, count);
        const double s = (texel.x + within.x) / texel.face_size;
        const double t = (texel.y + within.y) / texel.face_size;
        const LatLong at =
            lat_long_towards(panorama_from_cube * direction_on_face(texel.face, s, t));
        // A point of the face at distance d from the centre of the cube sees d^-3 of its area.
        const double distance2 = 1 + std::pow(2 * s - 1, 2) + std::pow(2 * t - 1, 2);
        points.push_back({place(at.v, height_), place(at.u, 2 * height_),
                          1 / (distance2 * std::sqrt(distance2))});
    }
    std::ranges::stable_sort(points, {}, &Point::row);
    return points;
}

void TexelMeans::add_rows(int row_count, const float* texels, int floats_per_texel) {
    const int end = next_row_ + row_count;
    parallel_rows(int(means_.size()), [&](int i) {
        Mean& mean = means_[size_t(i)];
        for (; mean.done < mean.points.size() && mean.points[mean.done].row < end; ++mean.done) {
            const Point& point = mean.points[mean.done];
            const size_t texel =
                size_t(point.row - next_row_) * 2 * size_t(height_) + size_t(point.column);
            const float* radiance = texels + texel * size_t(floats_per_texel);
            mean.sum += point.weight * Vec3d(radiance[0], radiance[1], radiance[2]);
        }
    });
    next_row_ = end;
}

std::vector<Vec3> TexelMeans::finish() const {
    std::vector<Vec3> radiance;
    for (const Mean& mean : means_) radiance.push_back(Vec3(mean.sum / mean.total));
    return radiance;
}

}  // namespace splitsum
