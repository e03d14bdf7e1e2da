#include "splitsum/preview/difference.h"

#include <algorithm>
#include <cmath>

#include "splitsum/image/luminance.h"

namespace splitsum {
namespace {

using Color = std::array<uint8_t, 3>;

constexpr Color none = {255, 255, 255};
constexpr Color too_bright = {176, 20, 32};
constexpr Color too_dark = {22, 70, 168};

double luminance_at(const Image& picture, size_t pixel) {
    const float* const p = picture.rgb.data() + 3 * pixel;
    return luminance(Vec3d(p[0], p[1], p[2]));
}

}  // namespace

double least_luminance(const TruthPicture& truth) {
    double sum = 0;
    int64_t pixels = 0;
    for (size_t i = 0; i < truth.mean.size(); ++i)
        if (truth.sphere_at[i] != TruthPicture::background) {
            sum += luminance(truth.mean[i]);
            ++pixels;
        }
    return pixels > 0 ? TruthPicture::least_share * sum / double(pixels) : 0;
}

Color difference_color(double relative) {
    const double share = std::min(std::abs(relative) / full_difference, 1.0);
    const Color& end = relative > 0 ? too_bright : too_dark;
    Color color;
    for (size_t c = 0; c < 3; ++c)
        color[c] = uint8_t(std::lround(none[c] + share * (end[c] - none[c])));
    return color;
}

std::vector<uint8_t> difference_picture(const Image& baked, const TruthPicture& truth) {
    const double least = least_luminance(truth);
    std::vector<uint8_t> bytes;
    bytes.reserve(3 * truth.mean.size());
    for (size_t i = 0; i < truth.mean.size(); ++i) {
        Color color = difference_background;
        if (truth.sphere_at[i] != TruthPicture::background) {
            const double exact = luminance(truth.mean[i]);
            const double floor = std::max(exact, least);
            color = difference_color(floor > 0 ? (luminance_at(baked, i) - exact) / floor : 0);
        }
        bytes.insert(bytes.end(), color.begin(), color.end());
    }
    return bytes;
}

}  // namespace splitsum
