#include "splitsum/verify/probe_texels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>

#include "splitsum/sphere/cubemap.h"

namespace splitsum {
namespace {

// Point i of the lattice: heights in equal steps, azimuths a golden angle apart.
Vec3d lattice_direction(int i, int count, double turn) {
    const double height = 1 - (2 * i + 1.0) / count;
    const double ring = std::sqrt((1 - height) * (1 + height));
    const double azimuth = 2 * std::numbers::pi * (i / std::numbers::phi + turn);
    return {ring * std::sin(azimuth), height, ring * std::cos(azimuth)};
}

int64_t texel_towards(const Vec3d& direction, int face_size) {
    const FacePoint point = face_point_towards(direction);
    const auto place = [&](double s) { return std::clamp(int(s * face_size), 0, face_size - 1); };
    return (int64_t(point.face) * face_size + place(point.t)) * face_size + place(point.s);
}

}  // namespace

std::vector<ProbeTexel> probe_texels(int face_size, int count) {
    const int64_t all = int64_t(face_count) * face_size * face_size;
    const int taken_count = int(std::min<int64_t>(all, count));
    const double turn = std::sqrt(2.0) * face_size;
    std::set<int64_t> taken;
    std::vector<ProbeTexel> probes;
    for (int i = 0; i < taken_count; ++i) {
        int64_t texel =
            all <= count ? i : texel_towards(lattice_direction(i, count, turn), face_size);
        while (!taken.insert(texel).second) texel = (texel + 1) % all;
        probes.push_back({int(texel / face_size / face_size), int(texel % face_size),
                          int(texel / face_size % face_size)});
    }
    return probes;
}

}  // namespace splitsum
