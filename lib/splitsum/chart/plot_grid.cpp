#include "splitsum/chart/plot_grid.h"

#include <algorithm>

#include "splitsum/base/text.h"

namespace splitsum {

PlotGrid::PlotGrid(int panels, const PlotLayout& layout) : layout_(layout) {
    layout_.columns = std::max(1, std::min(panels, layout.columns));
    rows_ = (panels + layout_.columns - 1) / layout_.columns;
}

// Pixels from the left and from the top.
std::string PlotGrid::margins(double left, double right, double top, double bottom) const {
    return cat("set lmargin at screen ", left / width(), "\nset rmargin at screen ",
               right / width(), "\nset tmargin at screen ", 1 - top / height(),
               "\nset bmargin at screen ", 1 - bottom / height(), "\n");
}

std::string PlotGrid::place(int index) const {
    const double left = index % layout_.columns * layout_.panel_width;
    const double top = layout_.heading + index / layout_.columns * layout_.panel_height;
    return margins(left + 75, left + layout_.panel_width - 18, top + 35,
                   top + layout_.panel_height - 60);
}

std::string PlotGrid::legend() const {
    return margins(20, width() - 20, height() - layout_.legend, height() - 10);
}

std::string PlotGrid::key(int entries) const {
    return cat("set key at screen 0.5, screen ", double(layout_.legend) / height(),
               " center top vertical maxrows ", (entries + 1) / 2,
               " Left reverse noenhanced samplen 2 width -5 font ',12'\n");
}

}  // namespace splitsum
