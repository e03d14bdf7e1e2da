#include "splitsum/preview/picture.h"

#include "splitsum/base/parallel.h"
#include "splitsum/sphere/cubemap_lookup.h"

namespace splitsum {
namespace {

void set_pixel(Image& picture, int x, int y, const Vec3d& light) {
    for (int c = 0; c < 3; ++c) picture.row(y)[size_t(3 * x + c)] = float(light[c]);
}

Vec3d behind(const Camera& camera, const BakedLight& light, Background background, int x, int y) {
    if (background == Background::black) return Vec3d(0);
    const Vec3d direction = camera.cube_from_view * ray_through(camera, x, y);
    return Vec3d(bilinear_lookup(light.specular.front(), direction));
}

Image image_of(const std::vector<Vec3>& pixels, const TruthPicture& truth) {
    Image picture(truth.width, truth.height);
    for (size_t i = 0; i < pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) picture.rgb[3 * i + size_t(c)] = pixels[i][c];
    return picture;
}

}  // namespace

Result<Image> baked_picture(const Scene& scene, const Camera& camera, const BakedLight& light,
                            Background background, Progress& progress) {
    Image picture(camera.width, camera.height);
    progress.begin("shade", camera.height);
    parallel_rows(camera.height, [&](int y) {
        if (progress.cancelled()) return;
        for (int x = 0; x < camera.width; ++x)
            if (const auto seen = first_surface(scene, camera, x, y))
                set_pixel(picture, x, y,
                          shade(light, scene.spheres[size_t(seen->sphere)].material, seen->normal,
                                seen->view));
        progress.advance(1);
    });
    if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted"};
    fill_background(picture, scene, camera, light, background);
    return picture;
}

Image picture_of(const TruthPicture& truth, const Scene& scene, const Camera& camera,
                 const BakedLight& light, Background background) {
    Image picture = image_of(truth.mean, truth);
    fill_background(picture, scene, camera, light, background);
    return picture;
}

Image standard_error_of(const TruthPicture& truth) { return image_of(truth.standard_error, truth); }

void fill_background(Image& picture, const Scene& scene, const Camera& camera,
                     const BakedLight& light, Background background) {
    parallel_rows(camera.height, [&](int y) {
        for (int x = 0; x < camera.width; ++x)
            if (!first_surface(scene, camera, x, y))
                set_pixel(picture, x, y, behind(camera, light, background, x, y));
    });
}

}  // namespace splitsum
