// What becomes of levels on their way out: pixel formats, and short harmonic series.
#include <algorithm>
#include <cmath>

#include "splitsum/atlas/answers.h"
#include "splitsum/atlas/entries.h"
#include "splitsum/atlas/pictures.h"
#include "splitsum/atlas/skies.h"
#include "splitsum/base/text.h"
#include "splitsum/filter/irradiance_harmonics.h"
#include "splitsum/sphere/area_filter.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {
namespace {

int64_t count_above(const Cubemap& cubemap, const PixelFormatInfo& format) {
    int64_t above = 0;
    for (const Vec3& texel : cubemap.texels)
        for (int c = 0; c < 3; ++c) above += texel[c] > format.largest[static_cast<size_t>(c)];
    return above;
}

float brightest(const Cubemap& cubemap) {
    float value = 0;
    for (const Vec3& texel : cubemap.texels)
        value = std::max(value, std::max({texel.x, texel.y, texel.z}));
    return value;
}

// A value that does not fit must become the largest that does, and count.
AtlasRow format_row(const Cubemap& level, const PixelFormatInfo& format) {
    std::vector<EncodeCounts> counts;
    const auto stored = cubemaps_of(texture_from_cubemaps({&level, 1}, format.format, counts));
    AtlasRow row{std::string(format.name)};
    if (!stored) {
        row.cells.assign(3, {.verdict = Verdict::fails, .text = stored.error().message});
        return row;
    }
    const Cubemap& read = stored->front();
    const int64_t above = count_above(level, format), wrong = count_no_light(read);
    const float largest = std::min(brightest(level), format.largest[0]);
    const auto cell = [](bool right, const std::string& text) {
        return AtlasCell{.verdict = right ? Verdict::meets : Verdict::fails, .text = text};
    };
    row.cells = {cell(brightest(read) == largest, cat(brightest(read))),
                 cell(counts.front().saturated == above,
                      cat(counts.front().saturated, " of ", above, " that do not fit")),
                 cell(wrong == 0, cat(wrong))};
    return row;
}

AtlasCell series_cell(const FilterSource& source, int order, bool windowed) {
    const IrradianceHarmonics series = irradiance_harmonics(source, order, windowed, Mat3d(1));
    const bool light = series.lowest >= -1e-6;
    return {.verdict = light ? Verdict::meets : Verdict::fails,
            .text = cat(light ? "never negative, down to " : "negative, down to ",
                        std::round(1e4 * series.lowest) / 1e2, " % of the mean")};
}

}  // namespace

Result<AtlasEntry> formats_entry(const AtlasPlan& plan, Progress& progress) {
    const Environment sky = overflowing_sky(plan.sky_rows);
    // Texels as small as the panorama's, so that values are not averaged away.
    const auto level = area_filtered_cubemap(sky, plan.sky_rows, Mat3d(1), progress);
    if (!level) return level.error();
    AtlasEntry entry{"formats", "Values above what the pixel format holds, up to 3e5",
                     "Inf in half floats, a black dot in shared exponents.",
                     "The largest value of the format is stored, and such values are counted and "
                     "reported; rgba32f keeps them."};
    if (plan.pictures) entry.png = picture_of(sky);
    entry.table = {"format", {"largest value stored", "values counted", "not light"}, {}};
    for (const PixelFormatInfo& format : pixel_formats())
        if (holds_colours(format)) entry.table.rows.push_back(format_row(*level, format));
    return entry;
}

Result<AtlasEntry> harmonics_entry(const AtlasPlan& plan, Progress& progress) {
    const Environment sky = sun_sky(plan.sky_rows, 1e6f);
    const FilterSource source(sky);
    AtlasEntry entry{"harmonics", "Short harmonic series of irradiance under a sun of 1e6",
                     "The series rings below 0: negative irradiance opposite the sun.",
                     "`--window` damps the bands just enough that nothing is negative; the report "
                     "says how low the series goes, with or without. Cubemaps do not need it."};
    if (plan.pictures) entry.png = picture_of(sky);
    entry.table = {"order", {"without a window", "--window"}, {}};
    for (const int order : {1, 2, 3, 4, 8}) {
        if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted"};
        entry.table.rows.push_back(
            {cat(order), {series_cell(source, order, false), series_cell(source, order, true)}});
    }
    return entry;
}

}  // namespace splitsum
