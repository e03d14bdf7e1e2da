#include "splitsum/sphere/orientation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

const Convention* find_convention(std::string_view name) {
    const auto all = conventions();
    const auto found = std::ranges::find(all, name, &Convention::name);
    return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::span<const Convention> conventions() {
    static constexpr Convention table[] = {
        {"ktx", "u = 1/2 + atan2(x, z) / 2pi: middle at +Z, right towards +X", 1, 0},
        {"khronos-sampler", "u = 1/2 + atan2(z, x) / 2pi: glTF-IBL-Sampler, mirrored", -1, 90},
        {"cmgen", "u = 1/2 + atan2(-x, z) / 2pi: Filament's cmgen, mirrored", -1, 0},
    };
    return table;
}

Status validate(const Orientation& orientation) {
    if (!find_convention(orientation.convention))
        return Error{ErrorKind::bad_argument,
                     cat("no convention '", orientation.convention, "'; there are: ",
                         join(conventions(), ", ", [](const Convention& c) { return c.name; }))};
    if (!std::isfinite(orientation.rotate_degrees))
        return Error{ErrorKind::bad_argument, cat("cannot rotate by ", orientation.rotate_degrees,
                                                  " degrees; a finite angle is needed")};
    return ok;
}

Mat3d panorama_from_cube(const Orientation& orientation) {
    // In azimuths: panorama = flip * (sign * cube + offset - rotation) = s * cube + o.
    const Convention& convention = *find_convention(orientation.convention);
    const double flip = orientation.mirror ? -1 : 1;
    const double s = flip * convention.sign;
    const double o = flip *
                     std::remainder(convention.offset_degrees - orientation.rotate_degrees, 360.0) *
                     std::numbers::pi / 180;
    // sin(s a + o) = s sin(a) cos(o) + cos(a) sin(o), and the cosine likewise.
    return Mat3d(Vec3d(s * std::cos(o), 0, -s * std::sin(o)), Vec3d(0, 1, 0),
                 Vec3d(std::sin(o), 0, std::cos(o)));
}

}  // namespace splitsum
