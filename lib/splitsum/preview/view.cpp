#include "splitsum/preview/view.h"

#include <algorithm>
#include <cmath>

#include "splitsum/base/edit_distance.h"
#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/color/display.h"
#include "splitsum/preview/tone_curve.h"

namespace splitsum {
namespace {

constexpr ViewInfo builtin_views[] = {
    {"aces", "ACES 1.0 SDR video output: compresses highlights"},
    {"filmic", "a simple filmic curve for each channel"},
    {"srgb", "clipped above 1: nothing is compressed"},
};

Error unknown_view(const std::string& name, const std::filesystem::path& ocio_config) {
    std::vector<std::string> names;
    for (const ViewInfo& view : views()) names.emplace_back(view.name);
    if (!ocio_config.empty()) {
        const auto more = views_of_config(ocio_config);
        if (!more) return more.error();
        names.insert(names.end(), more->begin(), more->end());
    }
    return {ErrorKind::bad_argument,
            cat("no view '", name, "'", names_instead(name, names),
                ocio_config.empty() ? "; more come with --ocio-config FILE" : "")};
}

}  // namespace

std::span<const ViewInfo> views() { return builtin_views; }

bool is_builtin(std::string_view view) {
    return std::ranges::find(builtin_views, view, &ViewInfo::name) != std::end(builtin_views);
}

Result<View> View::find(const std::string& name, const std::filesystem::path& ocio_config) {
    const auto curve = [](double (*encoded)(double)) {
        return View([encoded](std::span<float> rgb) {
            for (float& value : rgb) value = float(encoded(value));
        });
    };
    if (name == "srgb") return curve(srgb);
    if (name == "filmic") return curve(filmic);
    if (name != "aces" && name.find('/') == name.npos) return unknown_view(name, ocio_config);
    if (name != "aces" && ocio_config.empty()) return unknown_view(name, ocio_config);
    auto display =
        name == "aces" ? DisplayTransform::sdr() : DisplayTransform::of_config(ocio_config, name);
    if (!display) return display.error();
    const auto shared = std::make_shared<DisplayTransform>(std::move(*display));
    return View([shared](std::span<float> rgb) { shared->apply(rgb); });
}

std::vector<uint8_t> shown(const Image& picture, const View& view, double exposure_stops) {
    const auto exposure = float(std::exp2(exposure_stops));
    const size_t row_size = 3 * size_t(picture.width);
    std::vector<uint8_t> bytes(row_size * size_t(picture.height));
    parallel_rows(picture.height, [&](int y) {
        std::vector<float> row(picture.row(y).begin(), picture.row(y).end());
        for (float& value : row) value *= exposure;
        view.apply(row);
        const auto first = bytes.begin() + std::ptrdiff_t(row_size) * y;
        std::ranges::transform(row, first, [](float v) { return uint8_t(std::lround(255 * v)); });
    });
    return bytes;
}

}  // namespace splitsum
