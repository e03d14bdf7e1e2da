#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace splitsum::tools {

/// How far a run is.
struct LibraryState {
    size_t settled = 0;  ///< panoramas that are baked, up to date or failed
    size_t of = 0;
    double part = 0;                             ///< of the work, in [0, 1]
    std::optional<double> panoramas_a_minute{};  ///< nothing before the first
    std::optional<double> seconds_left{};
    std::vector<std::string> at{};  ///< what is being baked, longest first
};

/// The state in one line of fewer than `width` columns: "12/100  41 %  1:23 left  43/min", a bar, and
/// the names, as much of it as there is room for.
std::string library_bar(const LibraryState& state, int width);

/// The same for logs: without a bar, however long.
std::string library_line(const LibraryState& state);

/// "0:07", "12:30" or "3:04:05".
std::string clock_text(double seconds);

}  // namespace splitsum::tools
