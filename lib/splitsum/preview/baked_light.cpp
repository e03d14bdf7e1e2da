#include "splitsum/preview/baked_light.h"

#include "splitsum/shading/surface.h"
#include "splitsum/sphere/cubemap_lookup.h"
#include "splitsum/table/split_sum_lookup.h"
#include "splitsum/verify/reconstruction.h"

namespace splitsum {

Vec3d shade(const BakedLight& light, const Material& material, const Vec3d& normal,
            const Vec3d& view) {
    const double n_dot_v = dot(normal, view);
    const SurfaceResponse response =
        response_of(material.base_color, material.metalness,
                    look_up(light.split_sum, n_dot_v, material.perceptual_roughness));
    const Vec3d mirrored = 2 * n_dot_v * normal - view;
    const Vec3 specular =
        trilinear_lookup(light.specular, light.curve, mirrored, material.perceptual_roughness);
    return image_based_light(Vec3d(specular), Vec3d(bilinear_lookup(light.irradiance, normal)),
                             response.reflectance, response.diffuse_albedo);
}

}  // namespace splitsum
