#include "splitsum/imageio/row_bands_detail.h"

#include <algorithm>
#include <string>

namespace splitsum {
namespace {

// A few packets of rows for each thread of the decoder; EXR packs up to 32 rows together, DWAB 256,
// and less would decode each packet several times.
int rows_per_band(const OIIO::ImageSpec& spec) {
    if (spec.tile_width > 0) return spec.tile_height;
    const std::string compression = spec.get_string_attribute("compression");
    if (compression.starts_with("dwab")) return 256;
    constexpr int widest_of_64_rows = 32768;
    return spec.width > widest_of_64_rows ? 32 : 64;
}

void append_bands(std::vector<Band>& bands, int begin, int end, int phase, int step, bool data) {
    while (begin < end) {
        const int next = std::min(end, begin + step - (begin - phase) % step);
        bands.push_back({begin, next - begin, data});
        begin = next;
    }
}

}  // namespace

std::vector<Band> bands_of(const OIIO::ImageSpec& spec) {
    const int height = spec.full_height;
    const int data_begin = spec.y - spec.full_y;
    const int begin = std::clamp(data_begin, 0, height);
    const int end = std::clamp(data_begin + spec.height, begin, height);
    const int step = rows_per_band(spec);
    std::vector<Band> bands;
    append_bands(bands, 0, begin, 0, 64, false);
    append_bands(bands, begin, end, data_begin, step, true);
    append_bands(bands, end, height, end, 64, false);
    return bands;
}

FileRows file_rows_of(const OIIO::ImageSpec& spec, const Band& band) {
    FileRows rows{band.first_row + spec.full_y, band.first_row + band.row_count + spec.full_y};
    if (spec.tile_width == 0) return rows;
    rows.begin -= (rows.begin - spec.y) % spec.tile_height;
    const int tiles = (rows.end - spec.y + spec.tile_height - 1) / spec.tile_height;
    rows.end = std::min(spec.y + tiles * spec.tile_height, spec.y + spec.height);
    return rows;
}

}  // namespace splitsum
