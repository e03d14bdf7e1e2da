#include <algorithm>
#include <cmath>
#include <utility>

#include "splitsum/base/content_hash.h"
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

// In fp64: 2^stops may exceed the floats where the product does not.
void expose(std::span<float> row, double stops) {
    const double factor = std::exp2(stops);
    for (float& value : row) value = static_cast<float>(value * factor);
}

Status expose(const fs::path& path, double stops, Panorama& panorama) {
    panorama.exposure_stops = stops;
    if (stops == 0) return ok;
    parallel_rows(panorama.pixels.height, [&](int y) { expose(panorama.pixels.row(y), stops); });
    const Census census = take_census(panorama.pixels);
    if (census.clean()) return ok;
    return unusable(path, cat("leaves the range of floats with an exposure of ", stops,
                              " stops: ", describe(census)));
}

// In fp64, a float times 2^stops is finite for these; beyond, every panorama is black or infinite.
Status validate(const PanoramaOptions& options) {
    constexpr double most_stops = 128;
    if (std::abs(options.exposure_stops) <= most_stops) return ok;
    return Error{ErrorKind::bad_argument,
                 cat("cannot expose by ", options.exposure_stops, " stops; they must be from -",
                     most_stops, " to ", most_stops)};
}

// A file that is open, and everything that is known before its pixels are.
struct OpenPanorama {
    ImageReader reader;
    ColorChoice color;
    Panorama facts;
};

Result<OpenPanorama> open_panorama(const fs::path& path, const PanoramaOptions& options) {
    if (Status valid = validate(options); !valid) return valid.error();
    auto reader = ImageReader::open(path, options.layer);
    if (!reader) return reader.error();
    if (Status shape = check_shape(path, reader->info()); !shape) return shape.error();
    auto color = choose_color_space(reader->info(), options);
    if (!color) return color.error();

    Panorama facts;
    facts.source = path.filename().string();
    facts.reading = options;
    facts.color_space = color->name;
    facts.notes = reader->info().notes;
    facts.notes.insert(facts.notes.end(), color->notes.begin(), color->notes.end());
    return OpenPanorama{std::move(*reader), std::move(*color), std::move(facts)};
}

// Reads the rows and, beside that, the bytes for the hash.
Status read_rows(const fs::path& path, OpenPanorama& file, const RowSink& sink,
                 Progress& progress) {
    progress.begin("read", file.reader.info().height);
    const auto unless_cancelled = [&](int first_row, int row_count,
                                      std::span<float> rgb) -> Status {
        if (progress.cancelled())
            return Error{ErrorKind::interrupted, "stopped while reading the panorama"};
        const Status taken = sink(first_row, row_count, rgb);
        progress.advance(row_count);
        return taken;
    };
    Status read = ok;
    Result<std::string> hash = std::string();
    run_both([&] { read = file.reader.read_rows(unless_cancelled); },
             [&] { hash = hash_of_file(path); });
    if (!read) return read;
    if (!hash) return hash.error();
    file.facts.source_hash = named_hash(*hash);
    return ok;
}

// Memory grows with the rows that arrive: a header that lies about the size costs nothing.
Result<Image> collect_rows(const fs::path& path, OpenPanorama& file, Progress& progress) {
    Image image;
    image.width = file.reader.info().width;
    image.height = file.reader.info().height;
    const auto append = [&](int, int, std::span<float> rgb) -> Status {
        if (image.rgb.empty())
            image.rgb.reserve(3 * static_cast<size_t>(image.width) *
                              static_cast<size_t>(image.height));
        image.rgb.insert(image.rgb.end(), rgb.begin(), rgb.end());
        return ok;
    };
    if (Status read = read_rows(path, file, append, progress); !read) return read.error();
    return image;
}

// Turns pixels as they are in the file into light.
Status develop(const fs::path& path, const ColorConverter& converter,
               const PanoramaOptions& options, Panorama& panorama) {
    Status status = take_out_defects(path, options.repair, panorama);
    if (status) status = convert_colors(path, converter, options.repair, panorama);
    if (status) status = expose(path, options.exposure_stops, panorama);
    return status;
}

// The same for one row; false where it holds or becomes what is no light.
bool develop_row(std::span<float> row, const ColorConverter& converter, double stops) {
    if (!all_are_radiance(row)) return false;
    converter.apply(row);
    if (stops != 0) expose(row, stops);
    return (converter.changes_nothing() && stops == 0) || all_are_radiance(row);
}

bool develop_rows(std::span<float> rgb, int row_count, const ColorConverter& converter,
                  double stops) {
    const size_t row_size = rgb.size() / static_cast<size_t>(row_count);
    const auto failures = ordered_sum(row_count, [&](int y) {
        const auto row = rgb.subspan(static_cast<size_t>(y) * row_size, row_size);
        return develop_row(row, converter, stops) ? 0 : 1;
    });
    return failures == 0;
}

}  // namespace

Result<Panorama> read_panorama(const fs::path& path, const PanoramaOptions& options,
                               Progress& progress) {
    auto file = open_panorama(path, options);
    if (!file) return file.error();
    auto pixels = collect_rows(path, *file, progress);
    if (!pixels) return pixels.error();
    Panorama panorama = std::move(file->facts);
    panorama.pixels = std::move(*pixels);
    if (Status light = develop(path, file->color.converter, options, panorama); !light)
        return light.error();
    return panorama;
}

Result<PanoramaSize> panorama_size(const fs::path& path, const PanoramaOptions& options) {
    const auto reader = ImageReader::open(path, options.layer);
    if (!reader) return reader.error();
    if (Status shape = check_shape(path, reader->info()); !shape) return shape.error();
    const ImageFileInfo& info = reader->info();
    const int64_t whole = options.repair ? int64_t{12} * info.width * info.height : 0;
    return PanoramaSize{info.width, info.height, info.reading_bytes + whole};
}

Result<Panorama> stream_panorama(const fs::path& path, const PanoramaOptions& options,
                                 const PanoramaRows& rows, const std::function<void()>& restart,
                                 Progress& progress) {
    auto file = open_panorama(path, options);
    if (!file) return file.error();
    bool defective = false;
    const auto develop_and_pass_on = [&](int first_row, int row_count,
                                         std::span<float> rgb) -> Status {
        defective = !develop_rows(rgb, row_count, file->color.converter, options.exposure_stops);
        if (defective) return unusable(path, "holds pixels that are no light");
        rows(first_row, row_count, rgb);
        return ok;
    };
    const Status read = read_rows(path, *file, develop_and_pass_on, progress);
    if (defective) {
        restart();
        auto panorama = read_panorama(path, options, progress);
        if (panorama) rows(0, panorama->pixels.height, panorama->pixels.rgb);
        return panorama;
    }
    if (!read) return read.error();
    file->facts.exposure_stops = options.exposure_stops;
    return std::move(file->facts);
}

}  // namespace splitsum
