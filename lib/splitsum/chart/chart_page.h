#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "splitsum/chart/chart.h"

namespace splitsum {

/// A picture to be carried by the page.
struct InlinedPicture {
    std::string svg;      ///< the file's bytes
    std::string caption;  ///< also for those who cannot see it
};

/// A page that stands alone: the pictures, the tables of all panels, a sentence about every method,
/// and the conditions. Readable on a phone; needs no script and loads nothing. `pictures` are those
/// of panel_pictures in their order, or none, which `missing` then explains.
std::string chart_page(const Chart& chart, const std::vector<InlinedPicture>& pictures,
                       std::string_view missing);

}  // namespace splitsum
