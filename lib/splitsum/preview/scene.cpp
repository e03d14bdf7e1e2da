#include "splitsum/preview/scene.h"

#include "splitsum/base/text.h"

namespace splitsum {

Scene textbook_scene() {
    constexpr int columns = 7;
    constexpr Vec3d white{0.9}, gold{1.0, 0.782, 0.344};
    Scene scene;
    for (int metalness : {0, 1})
        for (int column = 0; column < columns; ++column) {
            const double perceptual_roughness = double(column) / (columns - 1);
            scene.spheres.push_back(
                {cat(metalness ? "metal " : "dielectric ", column),
                 Vec3d(column - 0.5 * (columns - 1), 0.5 - metalness, 0),
                 0.45,
                 {metalness ? gold : white, double(metalness), perceptual_roughness}});
        }
    return scene;
}

}  // namespace splitsum
