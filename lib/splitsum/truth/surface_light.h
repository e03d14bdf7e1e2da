#pragma once

#include <cmath>

#include "splitsum/brdf/lambert.h"
#include "splitsum/brdf/visible_normals.h"
#include "splitsum/filter/mis_light.h"
#include "splitsum/math/vec.h"
#include "splitsum/truth/surface.h"
#include "splitsum/truth/unsplit_brdf.h"

namespace splitsum {

/// One point of [0, 1)² for each way of choosing a direction.
struct SurfacePoints {
    Vec2d lobe, cosine, light;
};

/// Radiance from a point of a surface towards the viewer, ∫ f n·l L dl (f: unsplit_brdf.h), as a
/// part in closed form and a part to be sampled.
///
/// In closed form are the floor of the light (mis_light.h) times what the surface reflects of
/// uniform light, and the mirror image, of a mirror. The rest is estimated by multiple importance
/// sampling (Veach & Guibas 1995) from three densities: reflections at visible normals, the cosine,
/// which metals do without, and the light. A direction l drawn from density p_i counts with a share
/// w_i(l) of f n·l L / p_i, and the shares of all densities at one direction add up to 1.
class SurfaceLight {
public:
    /// `surface` is in panorama space. `light` must outlive this.
    SurfaceLight(const LightSampler& light, const Surface& surface);

    const Vec3d& closed_form() const { return closed_form_; }

    /// How many directions estimate() draws: one from each density that matters, and none where
    /// closed_form() is all there is: constant light, metal mirrors.
    int densities() const {
        const int of_surface = int(brdf_.alpha() > 0) + int(brdf_.is_diffuse());
        return light_.is_flat() || of_surface == 0 ? 0 : of_surface + 1;
    }

    /// An estimate of the rest, not of an exact surface: unbiased for points that are uniform each.
    /// `share` is that of mis_estimate.h, share(own, other): PowerShare is right. Cost: about 0.2
    /// microseconds a direction.
    template <class Share>
    Vec3d estimate(const SurfacePoints& points, const Share& share) const {
        Vec3d sum(0);
        if (brdf_.alpha() > 0) sum += by_lobe(points.lobe, share);
        if (brdf_.is_diffuse()) sum += by_cosine(points.cosine, share);
        return sum + by_light(points.light, share);
    }

private:
    // What the power heuristic makes of two others at once: the square is the sum of squares.
    static double both(double a, double b) { return std::sqrt(a * a + b * b); }

    template <class Share>
    Vec3d by_lobe(const Vec2d& point, const Share& share) const {
        const Vec3d half = sample_visible_normal(brdf_.view(), point, brdf_.alpha());
        const Vec3d direction = 2 * dot(brdf_.view(), half) * half - brdf_.view();
        const UnsplitBrdf::Value value = brdf_.towards(direction, half);
        if (value.lobe_pdf == 0) return Vec3d(0);
        const auto from = light_.towards(in_panorama(direction));
        return from.light * value.reflected *
               (share(value.lobe_pdf, both(value.cosine_pdf, from.pdf)) / value.lobe_pdf);
    }

    template <class Share>
    Vec3d by_cosine(const Vec2d& point, const Share& share) const {
        const Vec3d direction = sample_cosine_direction(point);
        const UnsplitBrdf::Value value = brdf_.towards(direction);
        if (value.cosine_pdf == 0) return Vec3d(0);
        const auto from = light_.towards(in_panorama(direction));
        return from.light * value.reflected *
               (share(value.cosine_pdf, both(value.lobe_pdf, from.pdf)) / value.cosine_pdf);
    }

    template <class Share>
    Vec3d by_light(const Vec2d& point, const Share& share) const {
        const auto from = light_.sample(point);
        const UnsplitBrdf::Value value = brdf_.towards(on_surface(from.direction));
        if (value.reflected == Vec3d(0)) return Vec3d(0);
        return from.light * value.reflected *
               (share(from.pdf, both(value.lobe_pdf, value.cosine_pdf)) / from.pdf);
    }

    Vec3d in_panorama(const Vec3d& d) const {
        return frame_.tangent * d.x + frame_.bitangent * d.y + frame_.normal * d.z;
    }
    Vec3d on_surface(const Vec3d& d) const {
        return {dot(d, frame_.tangent), dot(d, frame_.bitangent), dot(d, frame_.normal)};
    }

    const LightSampler& light_;
    Basis frame_;
    UnsplitBrdf brdf_;
    Vec3d closed_form_;
};

}  // namespace splitsum
