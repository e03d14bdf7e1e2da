#include "splitsum/imageio/image_file.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <new>
#include <utility>

#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/imageio/channel_choice_detail.h"
#include "splitsum/imageio/file_check_detail.h"
#include "splitsum/imageio/half_detail.h"
#include "splitsum/imageio/row_bands_detail.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

Error unreadable(const fs::path& path, std::string reason) {
    while (!reason.empty() && (reason.back() == '\n' || reason.back() == ' ')) reason.pop_back();
    std::ranges::replace(reason, '\n', ' ');
    return {ErrorKind::unreadable_input, cat("cannot read ", path.string(), ": ", reason)};
}

void remove_all(std::string& text, const std::string& part) {
    for (size_t at; (at = text.find(part)) != std::string::npos;) text.erase(at, part.size());
}

/// OpenImageIO's reason without the path and the name of the library below, which we say once.
std::string plain_reason(std::string reason, const fs::path& path) {
    const std::string quoted = cat('"', path.string(), "\"");
    for (const std::string& part :
         {std::string("OpenEXR exception: "), std::string("Failed OpenEXR read: "),
          cat("Cannot read image file ", quoted, ". "), cat(" from image file ", quoted)})
        remove_all(reason, part);
    if (reason.starts_with(quoted)) reason.replace(0, quoted.size(), "it");
    return reason;
}

Error unusable(const fs::path& path, const std::string& what) {
    return {ErrorKind::unusable_input, cat(path.string(), " ", what)};
}

/// Runs `work`; what OpenImageIO and the libraries below it throw becomes an error.
template <class Work>
auto guarded(const fs::path& path, const Work& work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return unreadable(path, "it claims more pixels than fit into memory");
    } catch (const std::exception& thrown) {
        return unreadable(path, thrown.what());
    }
}

/// Upright rows, or why they could not be read.
struct DecodedBand {
    Band band{};
    std::vector<float> rgb;
    Status status = ok;
};

/// Pixels of the data window outside the display window, and the other way round.
std::vector<std::string> window_notes(const OIIO::ImageSpec& spec) {
    std::vector<std::string> notes;
    const int left = spec.x - spec.full_x, top = spec.y - spec.full_y;
    const int right = left + spec.width, bottom = top + spec.height;
    const auto windows =
        cat("the data window of ", spec.width, "x", spec.height, " pixels starts at x ", left,
            ", y ", top, " of the display window of ", spec.full_width, "x", spec.full_height);
    if (left > 0 || top > 0 || right < spec.full_width || bottom < spec.full_height)
        notes.push_back(windows + "; the display window is black where there is no data");
    if (left < 0 || top < 0 || right > spec.full_width || bottom > spec.full_height)
        notes.push_back(windows + "; data outside the display window was dropped");
    return notes;
}

Status check_windows(const fs::path& path, const OIIO::ImageSpec& spec) {
    const auto outside = [](int side) { return side < 1 || side > largest_image_side; };
    for (const auto& [width, height] :
         {std::pair{spec.full_width, spec.full_height}, std::pair{spec.width, spec.height}})
        if (outside(width) || outside(height))
            return unreadable(path,
                              cat("it claims ", width, "x", height, " pixels; sides from 1 to ",
                                  largest_image_side, " are read"));
    const int64_t left = int64_t{spec.x} - spec.full_x, top = int64_t{spec.y} - spec.full_y;
    if (left >= spec.full_width || top >= spec.full_height || left + spec.width <= 0 ||
        top + spec.height <= 0)
        return unusable(path, "has a data window outside its display window: there is no pixel");
    if (spec.depth > 1) return unusable(path, "is a volume; a flat image is needed");
    return ok;
}

std::optional<std::array<float, 8>> chromaticities_of(const OIIO::ImageSpec& spec) {
    std::array<float, 8> values{};
    const OIIO::TypeDesc type(OIIO::TypeDesc::FLOAT, 8);
    if (!spec.getattribute("chromaticities", type, values.data())) return std::nullopt;
    return values;
}

// Rows that an EXR file packs together, which is how a decoder unpacks them.
int packet_rows(const OIIO::ImageSpec& spec) {
    if (spec.tile_width > 0) return spec.tile_height;
    const std::string compression = spec.get_string_attribute("compression");
    if (compression.starts_with("dwab")) return 256;
    return compression.starts_with("zip") ? 16 : 32;
}

// Three bands on their way (read_rows), one with the values of the file, and what the decoder holds:
// OpenEXR three copies of two packets a thread.
int64_t reading_bytes_of(const OIIO::ImageSpec& spec) {
    int64_t rows = 0, file_rows = 0;
    for (const Band& band : bands_of(spec)) {
        const auto [begin, end] = file_rows_of(spec, band);
        rows = std::max<int64_t>(rows, band.row_count);
        file_rows = std::max<int64_t>(file_rows, end - begin);
    }
    constexpr int64_t widened = sizeof(float);
    const int64_t file_row = static_cast<int64_t>(spec.pixel_bytes(true)) * spec.width;
    const bool as_stored = spec.format == OIIO::TypeFloat && spec.tile_width == 0;
    const int64_t values =
        as_stored ? 0 : file_rows * std::min(spec.nchannels, 16) * widened * spec.width;
    const bool is_packed = !spec.get_string_attribute("compression").empty();
    const int64_t packed = is_packed ? 6 * ThreadLimit::available() * packet_rows(spec) : file_rows;
    return 3 * rows * 3 * widened * spec.full_width + values + packed * file_row;
}

ImageFileInfo info_of(const OIIO::ImageInput& file, const OIIO::ImageSpec& spec) {
    ImageFileInfo info;
    info.width = spec.full_width;
    info.height = spec.full_height;
    info.format_name = file.format_name();
    info.channels = spec.channelnames;
    info.floating_point = spec.format.is_floating_point();
    info.color_space = spec.get_string_attribute("oiio:ColorSpace");
    // OpenImageIO calls every file of the PNM family Rec709; its float member PFM is linear.
    if (info.format_name == "pnm" && info.floating_point) info.color_space = "Linear";
    info.chromaticities = chromaticities_of(spec);
    info.notes = window_notes(spec);
    info.reading_bytes = reading_bytes_of(spec);
    return info;
}

}  // namespace

struct ImageReader::State {
    fs::path path;
    std::unique_ptr<OIIO::ImageInput> file;
    OIIO::ImageSpec spec;  ///< of the chosen part
    int part = 0;
    ChannelChoice channels;
    ImageFileInfo info;
    bool flip_x = false;             ///< rows run from right to left
    bool flip_y = false;             ///< rows run from the bottom up
    std::vector<uint16_t> halves;    ///< of one band
    std::vector<float> file_values;  ///< of one band

    Status open_file();
    Status choose_part(const std::string& layer);
    Status apply_orientation();
    Status describe();
    std::vector<Band> upright_bands() const;
    Status read_upright(const Band& band, std::vector<float>& rgb);
    int upright_row(const Band& band) const;
    Status read_band(const Band& band, std::vector<float>& rgb);
    bool is_stored_as_wanted(const Band& band) const;
    bool is_stored_as(OIIO::TypeDesc type) const;
    Status read_stored(const Band& band, void* values);
    Status read_as_stored(const Band& band, std::vector<float>& rgb);
    Status failed_read();
    Status read_channels(int begin, int end, const Band& band, std::vector<float>& values);
    void place(const std::vector<float>& values, int stride, const std::array<int, 3>& from,
               std::array<bool, 3> wanted, const Band& band, std::vector<float>& rgb) const;
    void flip(const Band& band, std::vector<float>& rgb) const;
};

Status ImageReader::State::open_file() {
    OIIO::ImageSpec wishes;
    wishes["oiio:UnassociatedAlpha"] = 1;  // colours as stored; alpha is dropped
    const int threads = ThreadLimit::available();
    file = OIIO::ImageInput::open(path.string(), &wishes);
    if (!file) {
        const std::string reason = plain_reason(OIIO::geterror(), path);
        if (reason.starts_with("Subsampled channels"))
            return unusable(path,
                            "holds luminance and subsampled chroma (Y, RY, BY); save it with R, G "
                            "and B channels");
        return unreadable(path, reason.empty() ? "not an image that OpenImageIO knows" : reason);
    }
    file->threads(threads);
    return ok;
}

Status ImageReader::State::choose_part(const std::string& layer) {
    std::optional<Error> first_failure;
    for (int i = 0; file->seek_subimage(i, 0); ++i) {
        const OIIO::ImageSpec candidate = file->spec();
        auto choice = candidate.deep
                          ? Result<ChannelChoice>(Error{ErrorKind::unusable_input,
                                                        "holds deep data; flatten it first"})
                          : choose_channels(candidate.channelnames, layer);
        if (!choice) {
            if (!first_failure)
                first_failure =
                    Error{choice.error().kind, cat(path.string(), " ", choice.error().message)};
            continue;
        }
        part = i;
        channels = std::move(*choice);
        spec = candidate;
        return ok;
    }
    const std::string reason = file->geterror();
    if (first_failure) return *first_failure;
    return unreadable(path, reason.empty() ? "it holds no image" : reason);
}

// Exif orientations: 1 upright, 2 mirrored, 3 turned by half, 4 upside down; 5 to 8 are transposed.
Status ImageReader::State::apply_orientation() {
    const int orientation = spec.get_int_attribute("Orientation", 1);
    if (orientation >= 5 && orientation <= 8)
        return unusable(
            path, cat("is stored on its side (orientation ", orientation, "); save it upright"));
    flip_x = orientation == 2 || orientation == 3;
    flip_y = orientation == 3 || orientation == 4;
    if (flip_x || flip_y) info.notes.push_back(cat("set upright from orientation ", orientation));
    return ok;
}

Status ImageReader::State::describe() {
    if (Status valid = check_windows(path, spec); !valid) return valid;
    info = info_of(*file, spec);
    info.notes.insert(info.notes.end(), channels.notes.begin(), channels.notes.end());
    const bool more = part > 0 || file->seek_subimage(part + 1, 0);
    if (!file->seek_subimage(part, 0)) return unreadable(path, file->geterror());
    file->geterror();  // the question whether there is another part may have left one
    const std::string name = spec.get_string_attribute("oiio:subimagename");
    if (more)
        info.notes.push_back(cat("the file has several images; read number ", part + 1,
                                 name.empty() ? "" : cat(" ('", name, "')")));
    return apply_orientation();
}

Status ImageReader::State::read_channels(int begin, int end, const Band& band,
                                         std::vector<float>& values) {
    const auto [y_begin, y_end] = file_rows_of(spec, band);
    values.resize(static_cast<size_t>(end - begin) * static_cast<size_t>(spec.width) *
                  static_cast<size_t>(y_end - y_begin));
    const bool read =
        spec.tile_width > 0
            ? file->read_tiles(part, 0, spec.x, spec.x + spec.width, y_begin, y_end, spec.z,
                               spec.z + 1, begin, end, OIIO::TypeFloat, values.data())
            : file->read_scanlines(part, 0, y_begin, y_end, spec.z, begin, end, OIIO::TypeFloat,
                                   values.data());
    return read ? ok : failed_read();
}

Status ImageReader::State::failed_read() {
    const std::string reason = plain_reason(file->geterror(), path);
    return unreadable(path, reason.empty() ? "the file ends before its pixels do" : reason);
}

void ImageReader::State::place(const std::vector<float>& values, int stride,
                               const std::array<int, 3>& from, std::array<bool, 3> wanted,
                               const Band& band, std::vector<float>& rgb) const {
    const int left = spec.x - spec.full_x;
    const int x_begin = std::max(left, 0), x_end = std::min(left + spec.width, spec.full_width);
    const int above = band.first_row + spec.full_y - file_rows_of(spec, band).begin;
    for (int row = 0; row < band.row_count; ++row) {
        const float* in = values.data() + static_cast<size_t>(row + above) *
                                              static_cast<size_t>(spec.width) *
                                              static_cast<size_t>(stride);
        float* out = rgb.data() + 3 * static_cast<size_t>(row) * static_cast<size_t>(info.width);
        for (int x = x_begin; x < x_end; ++x)
            for (size_t c = 0; c < 3; ++c)
                if (wanted[c]) out[3 * x + static_cast<int>(c)] = in[(x - left) * stride + from[c]];
    }
}

// Red, green, blue side by side and whole rows of the display window: most files.
bool ImageReader::State::is_stored_as_wanted(const Band& band) const {
    const auto [red, green, blue] = channels.rgb;
    const auto [begin, end] = file_rows_of(spec, band);
    return band.has_data && green == red + 1 && blue == red + 2 && spec.x == spec.full_x &&
           spec.width == spec.full_width && end - begin == band.row_count;
}

bool ImageReader::State::is_stored_as(OIIO::TypeDesc type) const {
    return spec.tile_width == 0 && spec.channelformats.empty() && spec.format == type;
}

Status ImageReader::State::read_stored(const Band& band, void* values) {
    const auto [begin, end] = file_rows_of(spec, band);
    const int first = channels.rgb[0];
    return file->read_native_scanlines(part, 0, begin, end, spec.z, first, first + 3, values)
               ? ok
               : failed_read();
}

// OpenImageIO takes longer to copy floats and to widen halves than to read them.
Status ImageReader::State::read_as_stored(const Band& band, std::vector<float>& rgb) {
    const size_t row_size = 3 * static_cast<size_t>(info.width);
    rgb.resize(row_size * static_cast<size_t>(band.row_count));
    if (is_stored_as(OIIO::TypeFloat)) return read_stored(band, rgb.data());
    if (!is_stored_as(OIIO::TypeHalf))
        return read_channels(channels.rgb[0], channels.rgb[0] + 3, band, rgb);
    halves.resize(rgb.size());
    if (Status read = read_stored(band, halves.data()); !read) return read;
    parallel_rows(band.row_count, [&](int row) {
        const size_t at = static_cast<size_t>(row) * row_size;
        widen_halves(halves.data() + at, row_size, rgb.data() + at);
    });
    return ok;
}

Status ImageReader::State::read_band(const Band& band, std::vector<float>& rgb) {
    if (is_stored_as_wanted(band)) return read_as_stored(band, rgb);
    const auto [first, last] = std::ranges::minmax(channels.rgb);
    rgb.assign(3 * static_cast<size_t>(info.width) * static_cast<size_t>(band.row_count), 0.0f);
    if (!band.has_data) return ok;
    // One read where the colours are near each other, three where a file has hundreds of channels.
    constexpr int widest_read = 16;
    if (last - first < widest_read) {
        if (Status read = read_channels(first, last + 1, band, file_values); !read) return read;
        const std::array from = {channels.rgb[0] - first, channels.rgb[1] - first,
                                 channels.rgb[2] - first};
        place(file_values, last + 1 - first, from, {true, true, true}, band, rgb);
        return ok;
    }
    for (size_t c = 0; c < 3; ++c) {
        const int channel = channels.rgb[c];
        if (Status read = read_channels(channel, channel + 1, band, file_values); !read)
            return read;
        place(file_values, 1, {0, 0, 0}, {c == 0, c == 1, c == 2}, band, rgb);
    }
    return ok;
}

void ImageReader::State::flip(const Band& band, std::vector<float>& rgb) const {
    const size_t row_size = 3 * static_cast<size_t>(info.width);
    const auto row = [&](int y) { return rgb.begin() + static_cast<ptrdiff_t>(y * row_size); };
    for (int y = 0; flip_y && y < band.row_count / 2; ++y)
        std::swap_ranges(row(y), row(y + 1), row(band.row_count - 1 - y));
    for (int y = 0; flip_x && y < band.row_count; ++y) {
        std::reverse(row(y), row(y + 1));  // pixels and channels
        for (auto pixel = row(y); pixel != row(y + 1); pixel += 3) std::swap(pixel[0], pixel[2]);
    }
}

// From the top of the upright image down.
std::vector<Band> ImageReader::State::upright_bands() const {
    std::vector<Band> bands = bands_of(spec);
    if (flip_y) std::ranges::reverse(bands);
    return bands;
}

Status ImageReader::State::read_upright(const Band& band, std::vector<float>& rgb) {
    return guarded(path, [&]() -> Status {
        if (Status read = read_band(band, rgb); !read) return read;
        flip(band, rgb);
        return ok;
    });
}

int ImageReader::State::upright_row(const Band& band) const {
    return flip_y ? info.height - band.first_row - band.row_count : band.first_row;
}

ImageReader::ImageReader(std::unique_ptr<State> state) : state_(std::move(state)) {}
ImageReader::ImageReader(ImageReader&&) noexcept = default;
ImageReader& ImageReader::operator=(ImageReader&&) noexcept = default;
ImageReader::~ImageReader() = default;

Result<ImageReader> ImageReader::open(const fs::path& path, const std::string& layer) {
    return guarded(path, [&]() -> Result<ImageReader> {
        if (Status readable = check_file(path); !readable) return readable.error();
        auto state = std::make_unique<State>();
        state->path = path;
        if (Status status = state->open_file(); !status) return status.error();
        if (Status status = state->choose_part(layer); !status) return status.error();
        if (Status status = state->describe(); !status) return status.error();
        return ImageReader(std::move(state));
    });
}

const ImageFileInfo& ImageReader::info() const { return state_->info; }

Status ImageReader::read_rows(const RowSink& sink) {
    State& state = *state_;
    const std::vector<Band> bands = state.upright_bands();
    std::array<DecodedBand, 3> buffers;
    size_t next = 0;
    Status status = ok;
    const auto decode = [&](DecodedBand& decoded) {
        if (next == bands.size()) return false;
        decoded.band = bands[next++];
        decoded.status = state.read_upright(decoded.band, decoded.rgb);
        if (!decoded.status) next = bands.size();
        return true;
    };
    const auto hand_over = [&](DecodedBand& decoded) {
        status = decoded.status;
        if (status)
            status = sink(state.upright_row(decoded.band), decoded.band.row_count, decoded.rgb);
        return static_cast<bool>(status);
    };
    return guarded(state.path, [&]() -> Status {
        make_and_take(std::span<DecodedBand>(buffers), decode, hand_over);
        return status;
    });
}

}  // namespace splitsum
