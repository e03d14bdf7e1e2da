#include <cmath>
#include <utility>

#include "splitsum/base/file_hash.h"
#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/imageio/image_file.h"
#include "splitsum/panorama/color_choice_detail.h"
#include "splitsum/panorama/panorama.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

Error unusable(const fs::path& path, const std::string& what) {
    return {ErrorKind::unusable_input, cat(path.string(), " ", what)};
}

Status check_shape(const fs::path& path, const ImageFileInfo& file) {
    if (file.width == 2 * file.height) return ok;
    return unusable(path, cat("is ", file.width, "x", file.height,
                              "; a lat-long panorama is twice as wide as high"));
}

// Memory grows with the rows that arrive: a header that lies about the size costs nothing.
Result<Image> collect_rows(ImageReader& reader, Progress& progress) {
    Image image;
    image.width = reader.info().width;
    image.height = reader.info().height;
    progress.begin("read", image.height);
    const Status read =
        reader.read_rows([&](int, int row_count, std::span<const float> rgb) -> Status {
            if (progress.cancelled())
                return Error{ErrorKind::interrupted, "stopped while reading the panorama"};
            if (image.rgb.empty())
                image.rgb.reserve(3 * static_cast<size_t>(image.width) *
                                  static_cast<size_t>(image.height));
            image.rgb.insert(image.rgb.end(), rgb.begin(), rgb.end());
            progress.advance(row_count);
            return ok;
        });
    if (!read) return read.error();
    return image;
}

Status take_out_defects(const fs::path& path, bool may_repair, Panorama& panorama) {
    panorama.found = take_census(panorama.pixels);
    if (panorama.found.clean()) return ok;
    if (!may_repair)
        return unusable(path, cat("holds pixels that are no light: ", describe(panorama.found),
                                  "; --repair replaces NaN and Inf from their neighbours and sets "
                                  "negative values to 0"));
    repair(panorama.pixels);
    panorama.repaired = true;
    panorama.notes.push_back(cat("repaired pixels: ", describe(panorama.found)));
    return ok;
}

Status convert_colors(const fs::path& path, const ColorConverter& converter, bool may_repair,
                      Panorama& panorama) {
    if (converter.changes_nothing()) return ok;
    converter.apply(panorama.pixels);
    const Census census = take_census(panorama.pixels);
    if (census.nan.count + census.infinite.count > 0)
        return unusable(path, cat("leaves the range of floats when it is converted from ",
                                  panorama.color_space, ": ", describe(census)));
    panorama.out_of_gamut = census.negative.count;
    if (census.clean()) return ok;
    if (!may_repair)
        return unusable(path, cat("holds colours outside the gamut of Rec.709: converted from ",
                                  panorama.color_space, " they are ", describe(census),
                                  "; --repair sets negative values to 0"));
    repair(panorama.pixels);
    panorama.repaired = true;
    panorama.notes.push_back(
        cat("set negative channels of colours outside the gamut of Rec.709 "
            "to 0: ",
            describe(census)));
    return ok;
}

Status expose(const fs::path& path, double stops, Panorama& panorama) {
    panorama.exposure_stops = stops;
    if (stops == 0) return ok;
    const double factor = std::exp2(stops);
    parallel_rows(panorama.pixels.height, [&](int y) {
        for (float& value : panorama.pixels.row(y)) value = static_cast<float>(value * factor);
    });
    const Census census = take_census(panorama.pixels);
    if (census.clean()) return ok;
    return unusable(path, cat("leaves the range of floats with an exposure of ", stops,
                              " stops: ", describe(census)));
}

Result<std::string> source_hash_of(const fs::path& path) {
    const auto hash = hash_of_file(path);
    if (!hash) return hash.error();
    return "xxh3-128:" + *hash;
}

// In fp64, a float times 2^stops is finite for these; beyond, every panorama is black or infinite.
Status validate(const PanoramaOptions& options) {
    constexpr double most_stops = 128;
    if (std::abs(options.exposure_stops) <= most_stops) return ok;
    return Error{ErrorKind::bad_argument,
                 cat("cannot expose by ", options.exposure_stops, " stops; they must be from -",
                     most_stops, " to ", most_stops)};
}

}  // namespace

Result<Panorama> read_panorama(const fs::path& path, const PanoramaOptions& options,
                               Progress& progress) {
    if (Status valid = validate(options); !valid) return valid.error();
    auto reader = ImageReader::open(path, options.layer);
    if (!reader) return reader.error();
    if (Status shape = check_shape(path, reader->info()); !shape) return shape.error();
    const auto color = choose_color_space(reader->info(), options);
    if (!color) return color.error();
    auto pixels = collect_rows(*reader, progress);
    if (!pixels) return pixels.error();
    const auto hash = source_hash_of(path);
    if (!hash) return hash.error();

    Panorama panorama;
    panorama.pixels = std::move(*pixels);
    panorama.source = path.filename().string();
    panorama.source_hash = *hash;
    panorama.color_space = color->name;
    panorama.notes = reader->info().notes;
    panorama.notes.insert(panorama.notes.end(), color->notes.begin(), color->notes.end());

    Status status = take_out_defects(path, options.repair, panorama);
    if (status) status = convert_colors(path, color->converter, options.repair, panorama);
    if (status) status = expose(path, options.exposure_stops, panorama);
    if (!status) return status.error();
    return panorama;
}

}  // namespace splitsum
