#include "splitsum/table/ltc_lookup.h"

#include <algorithm>

namespace splitsum {

Vec2d ltc_sphere_coordinates(double cos_to_centre, double form_factor, int size) {
    const auto placed = [&](double coordinate) {
        return (std::clamp(coordinate, 0.0, 1.0) * (size - 1) + 0.5) / size;
    };
    return {placed(0.5 * (cos_to_centre + 1)), placed(form_factor)};
}

}  // namespace splitsum
