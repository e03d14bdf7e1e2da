#include "splitsum/truth/surface_light.h"

namespace splitsum {

SurfaceLight::SurfaceLight(const LightSampler& light, const Surface& surface)
    : light_(light),
      frame_(surface.frame),
      brdf_(surface.alpha, surface.view, surface.response),
      closed_form_(light.floor() *
                   (surface.response.reflectance + surface.response.diffuse_albedo)) {
    if (surface.alpha == 0)
        closed_form_ += light.towards(mirrored_view(surface)).light * surface.response.reflectance;
}

}  // namespace splitsum
