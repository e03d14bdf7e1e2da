#pragma once

#include <string>

namespace splitsum {

/// Where panels stand in a picture: row by row under a heading, with a strip for the legend below.
class PlotGrid {
public:
    /// `panel_width` and `panel_height` in pixels, axis labels included; `legend_height` likewise.
    PlotGrid(int panels, int columns, int panel_width, int panel_height, int legend_height);

    int width() const { return columns_ * panel_width_; }
    int height() const { return heading_ + rows_ * panel_height_ + legend_height_; }

    /// gnuplot's margins for panel `index`, and for the strip of the legend.
    std::string place(int index) const;
    std::string legend() const;

private:
    std::string margins(double left, double right, double top, double bottom) const;

    static constexpr int heading_ = 50;
    int columns_;
    int rows_;
    int panel_width_;
    int panel_height_;
    int legend_height_;
};

}  // namespace splitsum
