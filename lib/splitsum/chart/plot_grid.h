#pragma once

#include <string>

namespace splitsum {

/// Sizes of the parts of a picture, in pixels; a panel's include its title and axis labels.
struct PlotLayout {
    int columns = 1;
    int panel_width = 480;
    int panel_height = 370;
    int heading = 0;
    int legend = 0;  ///< height of the strip at the bottom
};

/// Where panels stand in a picture: row by row under a heading, with a strip for the legend below.
class PlotGrid {
public:
    PlotGrid(int panels, const PlotLayout& layout);

    int width() const { return layout_.columns * layout_.panel_width; }
    int height() const { return layout_.heading + rows_ * layout_.panel_height + layout_.legend; }

    /// gnuplot's margins for panel `index`, and for the strip of the legend.
    std::string place(int index) const;
    std::string legend() const;
    /// The key of a single panel, of `entries` lines in two columns, in the strip.
    std::string key(int entries) const;

private:
    std::string margins(double left, double right, double top, double bottom) const;

    PlotLayout layout_;
    int rows_;
};

}  // namespace splitsum
