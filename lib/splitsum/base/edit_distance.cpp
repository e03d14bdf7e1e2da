#include "splitsum/base/edit_distance.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "splitsum/base/text.h"

namespace splitsum {

size_t edit_distance(std::string_view from, std::string_view to) {
    // row[j]: the distance from the part of `from` seen so far to the first j letters of `to`.
    std::vector<size_t> row(to.size() + 1);
    std::iota(row.begin(), row.end(), size_t{0});
    for (size_t i = 0; i < from.size(); ++i) {
        size_t diagonal = row[0];
        row[0] = i + 1;
        for (size_t j = 0; j < to.size(); ++j) {
            const size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

std::optional<std::string> nearest_name(std::string_view typed,
                                        std::span<const std::string> names) {
    const size_t most = 1 + typed.size() / 3;
    const std::string* nearest = nullptr;
    size_t smallest = most + 1;
    for (const std::string& name : names) {
        // The distance is at least the difference of the lengths: typed text may be very long.
        if (typed.size() > name.size() + most) continue;
        const size_t distance = edit_distance(typed, name);
        if (distance >= smallest) continue;
        smallest = distance;
        nearest = &name;
    }
    if (!nearest) return std::nullopt;
    return *nearest;
}

std::string names_instead(std::string_view typed, std::span<const std::string> names) {
    const auto nearest = nearest_name(typed, names);
    return cat(nearest ? cat("; did you mean ", *nearest, "? There are: ") : "; there are: ",
               join(names, ", "));
}

}  // namespace splitsum
