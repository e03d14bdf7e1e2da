#include "splitsum/picture/contact_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "splitsum/base/parallel.h"
#include "splitsum/color/display.h"
#include "splitsum/picture/exposure.h"
#include "splitsum/png/write_png.h"
#include "splitsum/sphere/cubemap_lookup.h"

namespace splitsum {
namespace {

constexpr int picture_width = 1600;
constexpr int gap = 24;
constexpr int bar_height = 6;
constexpr int largest_cell = 520;

constexpr std::array<uint8_t, 3> background = {30, 31, 34};
constexpr std::array<uint8_t, 3> bar_track = {52, 54, 59};
constexpr std::array<uint8_t, 3> bar_fill = {214, 160, 84};

/// One ball with its strip: a level, or the irradiance.
struct Cell {
    const Cubemap* cubemap;
    std::optional<double> perceptual_roughness;  ///< none for the irradiance
};

std::vector<Cell> cells_of(const ContactSheet& sheet) {
    std::vector<Cell> cells;
    for (const auto& level : sheet.levels)
        cells.push_back({level.cubemap, level.perceptual_roughness});
    if (sheet.irradiance) cells.push_back({sheet.irradiance, std::nullopt});
    return cells;
}

/// Where things are: cells in rows of equal size, each a ball over a strip over a bar.
struct Layout {
    int columns;
    int rows;
    int cell_width;
    int left;  ///< of the first column; rows of few cells are centred

    explicit Layout(int cells)
        : columns(columns_for(cells)),
          rows((cells + columns - 1) / columns),
          cell_width(std::min((picture_width - gap * (columns + 1)) / columns, largest_cell)),
          left((picture_width - columns * cell_width - (columns - 1) * gap) / 2) {}

    int ball() const { return cell_width; }
    int strip() const { return cell_width / 2; }
    int row_height() const { return ball() + gap / 2 + strip() + gap / 2 + bar_height + gap; }
    int height() const { return gap + rows * row_height(); }

private:
    // Full rows look best: of 4 and 5 columns the one that leaves fewer holes.
    static int columns_for(int cells) {
        if (cells <= 5) return cells;
        if (cells == 6) return 3;
        const auto holes = [&](int count) { return (count - cells % count) % count; };
        return holes(5) < holes(4) ? 5 : 4;
    }
};

/// A place of the picture in a cell: x and y in pixels from its upper left corner.
struct Place {
    int cell;
    double x;
    double y;
};

std::optional<Place> place_at(const Layout& layout, double x, double y) {
    const double from_left = x - layout.left, from_top = y - gap;
    if (from_left < 0 || from_top < 0) return std::nullopt;
    const int column = static_cast<int>(from_left / (layout.cell_width + gap));
    const int row = static_cast<int>(from_top / layout.row_height());
    const double in_x = from_left - column * (layout.cell_width + gap);
    if (column >= layout.columns || in_x >= layout.cell_width) return std::nullopt;
    return Place{row * layout.columns + column, in_x, from_top - row * layout.row_height()};
}

/// What a pixel shows: light, and how much of the pixel it covers; the rest is background.
struct Pixel {
    Vec3 light{0};
    float coverage = 0;
};

// The viewer stands at +z and looks back, so that the ball mirrors the middle of the panorama. Left
// and right are then swapped: +x stays to the right, as on the strip below. Beside the ball this is
// the direction at its rim.
Vec3d direction_on_ball(const Layout& layout, double x, double y, bool mirror) {
    const double radius = 0.5 * layout.ball();
    Vec3d normal((x - radius) / radius, (radius - y) / radius, 0);
    const double from_middle = length(normal);
    if (from_middle < 1)
        normal.z = std::sqrt((1 - from_middle) * (1 + from_middle));
    else
        normal = normal / from_middle;
    if (!mirror) return normal;
    const Vec3d to_viewer(0, 0, 1);
    return 2 * dot(normal, to_viewer) * normal - to_viewer;
}

Vec3d direction_on_strip(const Layout& layout, double x, double y) {
    const double azimuth = (x / layout.cell_width - 0.5) * 2 * std::numbers::pi;
    const double polar = (y - layout.ball() - gap / 2) / layout.strip() * std::numbers::pi;
    return Vec3d(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                 std::sin(polar) * std::cos(azimuth));
}

// Of the pixel around a place in a cell.
float coverage_at(const Layout& layout, const Place& place) {
    if (place.y >= layout.ball()) {
        const double down = place.y - layout.ball() - gap / 2;
        return down >= 0 && down < layout.strip() ? 1 : 0;
    }
    const double radius = 0.5 * layout.ball();
    const double from_middle = std::hypot(place.x - radius, place.y - radius);
    return float(std::clamp(radius - from_middle + 0.5, 0.0, 1.0));
}

// Samples along a pixel's edge: cubemaps with more texels than the strip has pixels would flicker.
int samples_of(const Cubemap& cubemap, const Layout& layout) {
    return 4 * cubemap.face_size > layout.cell_width ? 2 : 1;
}

// Light at a pixel. Bright samples count less in the mean, as they would if each were shown before
// (Karis 2014, "High Quality Temporal Supersampling"): a sun does not fray.
Vec3 light_at(const Layout& layout, const Cell& cell, const Place& place, float exposure) {
    const int n = samples_of(*cell.cubemap, layout);
    Vec3 sum(0);
    float weights = 0;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const double x = place.x + (i + 0.5) / n - 0.5, y = place.y + (j + 0.5) / n - 0.5;
            const Vec3d direction =
                place.y < layout.ball()
                    ? direction_on_ball(layout, x, y, cell.perceptual_roughness.has_value())
                    : direction_on_strip(layout, x, y);
            const Vec3 light = exposure * bilinear_lookup(*cell.cubemap, direction);
            const float weight = 1 / (1 + std::max({light.x, light.y, light.z}));
            sum += weight * light;
            weights += weight;
        }
    return sum / weights;
}

Pixel pixel_at(const Layout& layout, const std::vector<Cell>& cells, int x, int y, float exposure) {
    const auto place = place_at(layout, x + 0.5, y + 0.5);
    if (!place || place->cell >= static_cast<int>(cells.size())) return {};
    const float coverage = coverage_at(layout, *place);
    if (coverage == 0) return {};
    return {light_at(layout, cells[static_cast<size_t>(place->cell)], *place, exposure), coverage};
}

void draw_row(const Layout& layout, const std::vector<Cell>& cells, int y, float exposure,
              const DisplayTransform& display, std::span<uint8_t> row) {
    std::vector<float> coverage, shown;
    for (int x = 0; x < picture_width; ++x) {
        const Pixel pixel = pixel_at(layout, cells, x, y, exposure);
        coverage.push_back(pixel.coverage);
        if (pixel.coverage > 0)
            for (int c = 0; c < 3; ++c) shown.push_back(pixel.light[c]);
    }
    display.apply(shown);
    auto next = shown.begin();
    for (size_t x = 0; x < picture_width; ++x)
        for (size_t c = 0; c < 3; ++c) {
            const float lit = coverage[x] > 0 ? 255 * *next++ : 0;
            const float behind = static_cast<float>(background[c]);
            row[3 * x + c] =
                static_cast<uint8_t>(std::lround(behind + coverage[x] * (lit - behind)));
        }
}

void draw_bar(std::span<uint8_t> picture, const Layout& layout, int index, double fraction) {
    const int left = layout.left + index % layout.columns * (layout.cell_width + gap);
    const int top =
        gap + index / layout.columns * layout.row_height() + layout.ball() + gap + layout.strip();
    const int filled =
        static_cast<int>(std::lround(std::clamp(fraction, 0.0, 1.0) * layout.cell_width));
    for (int y = top; y < top + bar_height; ++y)
        for (int x = 0; x < layout.cell_width; ++x) {
            const auto& color = x < filled ? bar_fill : bar_track;
            std::ranges::copy(color, picture.begin() + 3 * (y * picture_width + left + x));
        }
}

}  // namespace

double exposure_stops_of(const ContactSheet& sheet) {
    const std::vector<Cell> cells = cells_of(sheet);
    return cells.empty() ? 0 : exposure_stops_of(*cells.front().cubemap);
}

Status write_contact_sheet(const ContactSheet& sheet, const std::filesystem::path& png) {
    const std::vector<Cell> cells = cells_of(sheet);
    if (cells.empty())
        return Error{ErrorKind::bad_argument,
                     "a contact sheet needs at least one level or the irradiance"};
    const auto display = DisplayTransform::sdr();
    if (!display) return display.error();

    const Layout layout(static_cast<int>(cells.size()));
    const auto exposure = static_cast<float>(std::exp2(exposure_stops_of(sheet)));
    constexpr size_t row_size = 3 * size_t{picture_width};
    std::vector<uint8_t> picture(row_size * static_cast<size_t>(layout.height()));
    parallel_rows(layout.height(), [&](int y) {
        draw_row(layout, cells, y, exposure, *display,
                 std::span(picture).subspan(static_cast<size_t>(y) * row_size, row_size));
    });
    for (size_t i = 0; i < cells.size(); ++i)
        if (cells[i].perceptual_roughness)
            draw_bar(picture, layout, static_cast<int>(i), *cells[i].perceptual_roughness);
    return write_png(png, picture_width, layout.height(), picture);
}

}  // namespace splitsum
