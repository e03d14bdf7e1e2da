#include "splitsum/atlas/pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "splitsum/png/write_png.h"

namespace splitsum {
namespace {

uint8_t shown(float radiance, float exposure) {
    const float light = exposure * radiance / (1 + exposure * radiance);
    const float encoded =
        light < 0.0031308f ? 12.92f * light : 1.055f * std::pow(light, 1 / 2.4f) - 0.055f;
    return static_cast<uint8_t>(std::lround(255 * std::clamp(encoded, 0.0f, 1.0f)));
}

void append(std::vector<uint8_t>& rgb, const Vec3& radiance, float exposure) {
    for (int c = 0; c < 3; ++c)
        if (!(std::isfinite(radiance[c]) && radiance[c] >= 0)) {
            rgb.insert(rgb.end(), {255, 0, 255});
            return;
        }
    for (int c = 0; c < 3; ++c) rgb.push_back(shown(radiance[c], exposure));
}

// Dark texels count as a thousandth of the mean, so that black ones do not decide alone.
float exposure_of(std::span<const Vec3> texels) {
    double mean = 0, logarithms = 0;
    const auto light = [](const Vec3& texel) {
        return static_cast<double>(texel.x + texel.y + texel.z) / 3;
    };
    for (const Vec3& texel : texels) mean += light(texel) / static_cast<double>(texels.size());
    if (!(mean > 0 && std::isfinite(mean))) return 1;
    for (const Vec3& texel : texels) logarithms += std::log(light(texel) + 1e-3 * mean);
    return static_cast<float>(0.25 / std::exp(logarithms / static_cast<double>(texels.size())));
}

// Nothing where libpng has no memory: a page without a picture.
std::string encoded(int width, int height, const std::vector<uint8_t>& rgb) {
    const auto file = png_of(width, height, rgb);
    if (!file) return {};
    return {reinterpret_cast<const char*>(file->data()), file->size()};
}

}  // namespace

float exposure_of(const Cubemap& cubemap) { return exposure_of(std::span(cubemap.texels)); }

std::string picture_of(const Environment& environment) {
    const Environment small =
        environment.height() > 64 ? averaged_down(environment, 64) : environment;
    std::vector<Vec3> texels;
    for (int y = 0; y < small.height(); ++y)
        for (int x = 0; x < small.width(); ++x) texels.push_back(small.texel(x, y));
    std::vector<uint8_t> rgb;
    for (const Vec3& texel : texels) append(rgb, texel, exposure_of(texels));
    return encoded(small.width(), small.height(), rgb);
}

std::string picture_of(const Cubemap& cubemap, float exposure) {
    constexpr int width = 32, height = 16;
    std::vector<uint8_t> rgb;
    const auto texel_of = [&](double place) {
        return std::min(static_cast<int>(place * cubemap.face_size), cubemap.face_size - 1);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const FacePoint at =
                face_point_towards(direction_of_lat_long((x + 0.5) / width, (y + 0.5) / height));
            append(rgb, cubemap.at(at.face, texel_of(at.s), texel_of(at.t)), exposure);
        }
    return encoded(width, height, rgb);
}

}  // namespace splitsum
