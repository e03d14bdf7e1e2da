#include "splitsum/preview/split_exact.h"

#include <algorithm>
#include <vector>

#include "splitsum/base/parallel.h"
#include "splitsum/preview/exact_light_detail.h"

namespace splitsum {
namespace {

// Pixels of one sphere.
struct SplitPixels {
    std::vector<int> indices;  // y * width + x
    std::vector<Surface> surfaces;
};

std::vector<SplitPixels> pixels_of_spheres(const Scene& scene, const Camera& camera,
                                           const Mat3d& panorama_from_cube) {
    const SphereSurfaces surfaces(scene, panorama_from_cube);
    std::vector<SplitPixels> of_sphere(scene.spheres.size());
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            if (const auto seen = first_surface(scene, camera, x, y)) {
                SplitPixels& pixels = of_sphere[size_t(seen->sphere)];
                pixels.indices.push_back(y * camera.width + x);
                pixels.surfaces.push_back(surfaces.at(*seen));
            }
    return of_sphere;
}

void draw(const SplitPixels& pixels, const ExactLight& light, Image& picture) {
    constexpr size_t at_once = 256;
    const size_t count = pixels.surfaces.size();
    parallel_rows(int((count + at_once - 1) / at_once), [&](int part) {
        const size_t begin = at_once * size_t(part);
        const auto surfaces =
            std::span(pixels.surfaces).subspan(begin, std::min(at_once, count - begin));
        const std::vector<SplitLight> lit = light.at(surfaces);
        for (size_t i = 0; i < surfaces.size(); ++i) {
            const Vec3 radiance = lit[i].seen_on(surfaces[i]);
            std::copy_n(&radiance.x, 3, &picture.rgb[3 * size_t(pixels.indices[begin + i])]);
        }
    });
}

// Up to `count` of each sphere's, evenly spread.
SplitPixels evenly_chosen(const std::vector<SplitPixels>& of_sphere, int count) {
    SplitPixels chosen;
    for (const SplitPixels& pixels : of_sphere) {
        const size_t all = pixels.indices.size();
        const size_t some = std::min(all, size_t(count));
        for (size_t i = 0; i < some; ++i) {
            const size_t place = (2 * i + 1) * all / (2 * some);
            chosen.indices.push_back(pixels.indices[place]);
            chosen.surfaces.push_back(pixels.surfaces[place]);
        }
    }
    return chosen;
}

Result<ErrorFigures> compared(const Image& picture, const SplitPixels& chosen,
                              const Environment& environment, Progress& progress) {
    const auto light = reference_light(environment, chosen.surfaces, progress);
    if (!light) return light.error();
    std::vector<Vec3> found, exact;
    for (size_t i = 0; i < chosen.indices.size(); ++i) {
        const float* const rgb = &picture.rgb[3 * size_t(chosen.indices[i])];
        found.emplace_back(rgb[0], rgb[1], rgb[2]);
        exact.push_back((*light)[i].seen_on(chosen.surfaces[i]));
    }
    return error_figures(found, exact);
}

}  // namespace

Result<SplitExact> split_exact(const Scene& scene, const Camera& camera,
                               const Environment& environment, const Mat3d& panorama_from_cube,
                               int checks, Progress& progress) {
    progress.begin("filtering", 1 + int(scene.spheres.size()));
    const std::vector<SplitPixels> of_sphere = pixels_of_spheres(scene, camera, panorama_from_cube);
    const ExactLight light(environment, scene);
    progress.advance(1);
    SplitExact result{Image(camera.width, camera.height), {}};
    for (const SplitPixels& pixels : of_sphere) {
        if (progress.cancelled())
            return Error{ErrorKind::interrupted, "interrupted while filtering"};
        draw(pixels, light, result.radiance);
        progress.advance(1);
    }
    const auto checked =
        compared(result.radiance, evenly_chosen(of_sphere, checks), environment, progress);
    if (!checked) return checked.error();
    result.checked = *checked;
    return result;
}

}  // namespace splitsum
