#pragma once

#include <string>
#include <vector>

#include "splitsum/math/vec.h"
#include "splitsum/shading/material.h"

namespace splitsum {

/// A sphere in front of the camera, in view axes: +x right, +y up, +z away from the viewer.
struct Sphere {
    std::string name;
    Vec3d centre{0};
    double radius = 0.45;  ///< > 0, in the units of `centre`
    Material material;
};

/// Spheres that do not see each other: each is lit by the whole environment, as image-based lighting
/// in an engine is. They stay in front of the camera; what turns is the light around them.
struct Scene {
    std::vector<Sphere> spheres;
};

/// The textbook comparison: dielectrics in the upper row, metals in the lower, perceptual roughness
/// 0, 1/6 ... 1 from left to right.
Scene textbook_scene();

}  // namespace splitsum
