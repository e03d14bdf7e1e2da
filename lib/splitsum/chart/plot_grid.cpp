#include "splitsum/chart/plot_grid.h"

#include <algorithm>

#include "splitsum/base/text.h"

namespace splitsum {

PlotGrid::PlotGrid(int panels, int columns, int panel_width, int panel_height, int legend_height)
    : columns_(std::max(1, std::min(panels, columns))),
      rows_((panels + columns_ - 1) / columns_),
      panel_width_(panel_width),
      panel_height_(panel_height),
      legend_height_(legend_height) {}

// Pixels from the left and from the top.
std::string PlotGrid::margins(double left, double right, double top, double bottom) const {
    return cat("set lmargin at screen ", left / width(), "\nset rmargin at screen ",
               right / width(), "\nset tmargin at screen ", 1 - top / height(),
               "\nset bmargin at screen ", 1 - bottom / height(), "\n");
}

std::string PlotGrid::place(int index) const {
    const double left = index % columns_ * panel_width_;
    const double top = heading_ + index / columns_ * panel_height_;
    return margins(left + 75, left + panel_width_ - 15, top + 35, top + panel_height_ - 60);
}

std::string PlotGrid::legend() const {
    const double top = height() - legend_height_;
    return margins(20, width() - 20, top, height() - 10);
}

}  // namespace splitsum
