#include "splitsum/chart/plot_text.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "splitsum/base/text.h"

namespace splitsum {

std::string gnuplot_string(std::string_view text) {
    std::string result = "\"";
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') result += '\\';
        result += letter == '\n' ? ' ' : letter;
    }
    return result + "\"";
}

std::string line_style(size_t place) {
    // Okabe & Ito's colours without yellow, which vanishes on white.
    constexpr std::array<std::string_view, 7> colours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                         "#E69F00", "#56B4E9", "#000000"};
    // Filled circle, square, triangle, diamond, triangle down, pentagon; the same ones open.
    constexpr std::array<int, 12> markers = {7, 5, 9, 13, 11, 15, 6, 4, 8, 12, 10, 14};
    const size_t round = place / colours.size();
    return cat("lc rgb '", colours[place % colours.size()], "' pt ",
               markers[place % markers.size()], " dt ", round % 4 + 1, " lw 2 ps 0.9");
}

LogRange range_around(double lowest, double highest) { return {lowest / 1.6, highest * 1.6}; }

std::string to_string(const LogRange& range) { return cat("[", range.from, ":", range.to, "]"); }

size_t place_of(const std::vector<MethodNote>& notes, std::string_view method) {
    const auto found = std::ranges::find(notes, method, &MethodNote::name);
    return size_t(found - notes.begin());
}

}  // namespace splitsum
