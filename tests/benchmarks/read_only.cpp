// read_only FILE: opens an image through OpenImageIO and reads its pixels as floats, nothing else.
// The floor under the time and memory of every program that reads the same file.

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdio>
#include <vector>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: read_only FILE\n");
        return 2;
    }
    const auto file = OIIO::ImageInput::open(argv[1]);
    if (!file) {
        std::fprintf(stderr, "read_only: %s\n", OIIO::geterror().c_str());
        return 3;
    }
    constexpr int band = 64;
    const OIIO::ImageSpec& spec = file->spec();
    std::vector<float> rows(size_t(band) * size_t(spec.width) * size_t(spec.nchannels));
    double sum = 0;
    for (int y = spec.y; y < spec.y + spec.height; y += band) {
        const int end = std::min(y + band, spec.y + spec.height);
        if (!file->read_scanlines(0, 0, y, end, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT,
                                  rows.data())) {
            std::fprintf(stderr, "read_only: %s\n", file->geterror().c_str());
            return 3;
        }
        sum += double(rows.front());
    }
    std::printf("%d x %d, %d channels, sum of the first column's samples %g\n", spec.width,
                spec.height, spec.nchannels, sum);
    return 0;
}
