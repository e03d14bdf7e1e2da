// make_large_panorama WIDTH FILE: a lat-long panorama of WIDTH x WIDTH/2, .hdr or half .exr: a sky
// with a gradient, noise in every texel (which no codec can shorten) and a sun of radiance 5e4, half
// a degree in radius. Written band by band, so that memory does not follow the size.

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>
#include <vector>

#include "splitsum/base/parallel.h"
#include "splitsum/base/random.h"
#include "splitsum/math/vec.h"

namespace {

using splitsum::Vec3;

constexpr double pi = std::numbers::pi;
constexpr int band_rows = 64;

struct Azimuth {
    float sine, cosine;
};

std::vector<Azimuth> azimuths_of(int width) {
    std::vector<Azimuth> azimuths;
    for (int x = 0; x < width; ++x) {
        const double azimuth = 2 * pi * ((x + 0.5) / width - 0.5);
        azimuths.push_back({float(std::sin(azimuth)), float(std::cos(azimuth))});
    }
    return azimuths;
}

Vec3 radiance_of(const Vec3& direction, uint32_t key) {
    static const Vec3 sun = normalize(Vec3(0.5f, 0.35f, -0.6f));
    const float height = 0.5f + 0.5f * direction.y;
    const Vec3 gradient = Vec3(0.5f, 0.4f, 0.35f) * (1 - height) + Vec3(0.3f, 0.5f, 0.9f) * height;
    const Vec3 noise = Vec3(0.9f + 0.2f * splitsum::unit_float(key),
                            0.9f + 0.2f * splitsum::unit_float(key ^ 0x55555555U),
                            0.9f + 0.2f * splitsum::unit_float(key ^ 0xaaaaaaaaU));
    const Vec3 away = direction - sun;
    const float radius = float(0.5 * pi / 180);
    return gradient * noise + (dot(away, away) < radius * radius ? Vec3(5e4f) : Vec3(0));
}

void fill_row(float* rgb, int y, int height, const std::vector<Azimuth>& azimuths) {
    const float sine = float(std::sin(pi * (y + 0.5) / height));
    const float cosine = float(std::cos(pi * (y + 0.5) / height));
    uint32_t key = uint32_t(y) * uint32_t(azimuths.size());
    for (const Azimuth& azimuth : azimuths) {
        const Vec3 light = radiance_of({sine * azimuth.sine, cosine, sine * azimuth.cosine}, key++);
        for (int c = 0; c < 3; ++c) *rgb++ = light[c];
    }
}

bool write_panorama(OIIO::ImageOutput& file, int width) {
    const int height = width / 2;
    const std::vector<Azimuth> azimuths = azimuths_of(width);
    const size_t row_floats = 3 * size_t(width);
    std::vector<float> band(band_rows * row_floats);
    for (int first = 0; first < height; first += band_rows) {
        const int count = std::min(band_rows, height - first);
        splitsum::parallel_rows(count, [&](int row) {
            fill_row(band.data() + size_t(row) * row_floats, first + row, height, azimuths);
        });
        if (!file.write_scanlines(first, first + count, 0, OIIO::TypeDesc::FLOAT, band.data()))
            return false;
    }
    return true;
}

// An even number in [2, 65536], or 0.
int parse_width(const char* text) {
    int width = 0;
    const char* end = text + std::strlen(text);
    const auto [rest, error] = std::from_chars(text, end, width);
    const bool usable = error == std::errc() && rest == end && width >= 2 && width <= 65536;
    return usable && width % 2 == 0 ? width : 0;
}

int failure(const char* what, const std::string& why) {
    std::fprintf(stderr, "make_large_panorama: %s: %s\n", what, why.c_str());
    return 4;
}

}  // namespace

int main(int argc, char** argv) {
    const int width = argc == 3 ? parse_width(argv[1]) : 0;
    if (width == 0) {
        std::fprintf(stderr, "usage: make_large_panorama WIDTH FILE.hdr|FILE.exr (WIDTH even)\n");
        return 2;
    }
    const auto file = OIIO::ImageOutput::create(argv[2]);
    if (!file) return failure(argv[2], OIIO::geterror());
    OIIO::ImageSpec spec(width, width / 2, 3, OIIO::TypeDesc::HALF);
    spec.attribute("compression", "zip");
    if (!file->open(argv[2], spec) || !write_panorama(*file, width) || !file->close())
        return failure(argv[2], file->geterror());
    return 0;
}
