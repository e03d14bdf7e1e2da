#include "splitsum/preview/split_exact.h"

#include <algorithm>

#include "splitsum/filter/reference_probes.h"
#include "splitsum/preview/sphere_surfaces.h"
#include "splitsum/verify/all_rows_detail.h"

namespace splitsum {
namespace {

struct SeenPixel {
    int index;
    SeenSurface seen;
};

std::vector<std::vector<SeenPixel>> pixels_of_spheres(const Scene& scene, const Camera& camera) {
    std::vector<std::vector<SeenPixel>> of_sphere(scene.spheres.size());
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            if (const auto seen = first_surface(scene, camera, x, y))
                of_sphere[size_t(seen->sphere)].push_back({y * camera.width + x, *seen});
    return of_sphere;
}

std::vector<SeenPixel> evenly_chosen(const std::vector<SeenPixel>& pixels, int most) {
    const size_t count = std::min(pixels.size(), size_t(most));
    std::vector<SeenPixel> chosen;
    for (size_t i = 0; i < count; ++i)
        chosen.push_back(pixels[(2 * i + 1) * pixels.size() / (2 * count)]);
    return chosen;
}

// A surface whose two kinds of light may still have to be integrated.
class SplitSurface {
public:
    explicit SplitSurface(const Surface& surface) : surface_(surface) {}

    // Adds what this surface needs to what is integrated.
    void ask(std::vector<ReferenceProbes::Probe>& probes) {
        if (surface_.alpha > 0) {
            specular_ = probes.size();
            probes.push_back({{LobeKind::ggx, surface_.alpha}, mirrored_view(surface_)});
        }
        diffuse_ = probes.size();
        if (surface_.response.diffuse_albedo != Vec3d(0))
            probes.push_back({{LobeKind::cosine}, surface_.frame.normal});
    }

    // When `integrals` of all probes are there.
    Vec3d radiance(const Environment& environment, const std::vector<Vec3>& integrals) const {
        const bool is_diffuse = surface_.response.diffuse_albedo != Vec3d(0);
        const Vec3 specular = surface_.alpha > 0
                                  ? integrals[specular_]
                                  : radiance_towards(environment, mirrored_view(surface_));
        return image_based_light(Vec3d(specular),
                                 is_diffuse ? Vec3d(integrals[diffuse_]) : Vec3d(0),
                                 surface_.response.reflectance, surface_.response.diffuse_albedo);
    }

private:
    Surface surface_;
    size_t specular_ = 0, diffuse_ = 0;  // places in the list of probes
};

}  // namespace

Result<std::vector<ExactPixel>> split_exact(const Scene& scene, const Camera& camera,
                                            const Environment& environment,
                                            const Mat3d& panorama_from_cube, int pixels_per_sphere,
                                            Progress& progress) {
    const SphereSurfaces surfaces(scene, panorama_from_cube);
    std::vector<ExactPixel> pixels;
    std::vector<SplitSurface> split;
    std::vector<ReferenceProbes::Probe> probes;
    for (const auto& of_sphere : pixels_of_spheres(scene, camera))
        for (const SeenPixel& pixel : evenly_chosen(of_sphere, pixels_per_sphere)) {
            pixels.push_back({pixel.index, pixel.seen.sphere, Vec3(0)});
            split.emplace_back(surfaces.at(pixel.seen)).ask(probes);
        }
    ReferenceProbes reference(environment.height(), probes);
    const Status added = add_all_rows(reference, int(probes.size()), environment, progress);
    if (!added) return added.error();
    const std::vector<Vec3> integrals = reference.finish();
    for (size_t i = 0; i < pixels.size(); ++i)
        pixels[i].radiance = Vec3(split[i].radiance(environment, integrals));
    return pixels;
}

}  // namespace splitsum
