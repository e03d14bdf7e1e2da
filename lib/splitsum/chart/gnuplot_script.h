#pragma once

#include <string>

#include "splitsum/chart/chart.h"

namespace splitsum {

/// A picture that the script makes of one panel, for the page.
struct PanelPicture {
    std::string file;     ///< "panel-0.svg", in the folder where the script runs
    std::string caption;  ///< what it shows, also for those who cannot see it
};

/// The pictures of the panels, those of what engines read last, in the order of the page.
std::vector<PanelPicture> panel_pictures(const Chart& chart);

/// A gnuplot script, data included, that writes into the folder where it runs: chart.svg and
/// chart.png with all panels, storage.svg and storage.png with what engines read, and
/// panel_pictures. Error against milliseconds, both logarithmic; a line with markers for each
/// method, in the colours of Okabe & Ito 2008 ("Color Universal Design"), which people with any kind
/// of colour vision can tell apart; the front of what nothing beats in grey behind them.
std::string gnuplot_script(const Chart& chart);

}  // namespace splitsum
