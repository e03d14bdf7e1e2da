#pragma once

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/image/image.h"
#include "splitsum/preview/baked_light.h"
#include "splitsum/preview/camera.h"
#include "splitsum/preview/scene.h"
#include "splitsum/preview/truth_picture.h"

namespace splitsum {

/// What is seen where no sphere is.
enum class Background {
    light,  ///< level 0 of the specular chain
    black,
};

/// The scene under the baked light, as an engine draws it: one sample a pixel, at its centre.
/// Scene-linear. The same bits for every number of threads. Progress: the stage "shade", one step a
/// row. Fails only when cancelled.
Result<Image> baked_picture(const Scene& scene, const Camera& camera, const BakedLight& light,
                            Background background, Progress& progress);

/// The truth as a picture: its mean before the same background, and its standard errors before black.
Image picture_of(const TruthPicture& truth, const Scene& scene, const Camera& camera,
                 const BakedLight& light, Background background);
Image standard_error_of(const TruthPicture& truth);

/// Draws the background behind the spheres of a picture of that scene and camera.
void fill_background(Image& picture, const Scene& scene, const Camera& camera,
                     const BakedLight& light, Background background);

}  // namespace splitsum
