#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "splitsum/math/vec.h"

namespace splitsum {

// Cubemaps are stored as KTX 2 and Vulkan define them (Vulkan 1.3, 16.5.4 "Cube Map Face
// Selection"): faces +X -X +Y -Y +Z -Z, left-handed, row 0 at the top, +Y up.

inline constexpr int face_count = 6;
inline constexpr std::array<std::string_view, face_count> face_names = {"+X", "-X", "+Y",
                                                                        "-Y", "+Z", "-Z"};

/// The unit direction of the point (s, t) of a face; s and t run from 0 to 1, right and down.
Vec3d direction_on_face(int face, double s, double t);

/// The unit direction of the centre of texel (x, y) of a face with `face_size` texels along its edge.
inline Vec3d direction_of_texel(int face, int x, int y, int face_size) {
    return direction_on_face(face, (x + 0.5) / face_size, (y + 0.5) / face_size);
}

/// The solid angle in steradians of texel (x, y), the same on every face. Exact: the four-corner
/// arctangent formula; the texels of a cube sum to 4 pi.
double solid_angle_of_texel(int x, int y, int face_size);

/// A point of a face: s and t in [0, 1].
struct FacePoint {
    int face;
    double s;
    double t;
};

/// Where `direction` (any length but 0) meets the cube: the inverse of direction_on_face.
FacePoint face_point_towards(const Vec3d& direction);

/// Six square faces of scene-linear RGB.
struct Cubemap {
    int face_size = 0;
    std::vector<Vec3> texels;  ///< face by face, row by row

    Cubemap() = default;
    explicit Cubemap(int size)
        : face_size(size),
          texels(static_cast<size_t>(face_count) * static_cast<size_t>(size) *
                 static_cast<size_t>(size)) {}

    size_t index_of(int face, int x, int y) const {
        return (static_cast<size_t>(face) * static_cast<size_t>(face_size) +
                static_cast<size_t>(y)) *
                   static_cast<size_t>(face_size) +
               static_cast<size_t>(x);
    }
    Vec3& at(int face, int x, int y) { return texels[index_of(face, x, y)]; }
    const Vec3& at(int face, int x, int y) const { return texels[index_of(face, x, y)]; }
    std::span<Vec3> row(int face, int y) {
        return {texels.data() + index_of(face, 0, y), static_cast<size_t>(face_size)};
    }
};

/// The mean over the sphere, each texel weighted by its solid angle, summed in fp64.
Vec3d mean_radiance(const Cubemap& cubemap);

}  // namespace splitsum
