#pragma once

#include "splitsum/sphere/cubemap.h"

namespace splitsum::tests {

/// The direction is the colour, so that what is mirrored or turned differs; another one for every
/// `level`, all above 0.
inline Cubemap direction_sky(int face_size, double level) {
    Cubemap cubemap(face_size);
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < face_size; ++y)
            for (int x = 0; x < face_size; ++x)
                cubemap.at(face, x, y) =
                    Vec3(Vec3d(1.5 + level) + direction_of_texel(face, x, y, face_size));
    return cubemap;
}

}  // namespace splitsum::tests
