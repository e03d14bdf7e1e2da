#include "splitsum/color/primaries.h"

#include <algorithm>
#include <cmath>

namespace splitsum {
namespace {

using Triple = std::array<double, 3>;

ColorMatrix operator*(const ColorMatrix& a, const ColorMatrix& b) {
    ColorMatrix product{};
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j)
            for (size_t k = 0; k < 3; ++k) product[3 * i + j] += a[3 * i + k] * b[3 * k + j];
    return product;
}

Triple operator*(const ColorMatrix& m, const Triple& v) {
    Triple product{};
    for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k) product[i] += m[3 * i + k] * v[k];
    return product;
}

// Row i, column j of the matrix without its row and column, signed: indices run around.
double cofactor(const ColorMatrix& m, size_t i, size_t j) {
    const size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return m[3 * i1 + j1] * m[3 * i2 + j2] - m[3 * i1 + j2] * m[3 * i2 + j1];
}

double determinant(const ColorMatrix& m) {
    return m[0] * cofactor(m, 0, 0) + m[1] * cofactor(m, 0, 1) + m[2] * cofactor(m, 0, 2);
}

ColorMatrix inverse(const ColorMatrix& m) {
    ColorMatrix result{};
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) result[3 * i + j] = cofactor(m, j, i) / determinant(m);
    return result;
}

ColorMatrix diagonal(const Triple& d) { return {d[0], 0, 0, 0, d[1], 0, 0, 0, d[2]}; }

Triple white_of(const Primaries& p) { return {p[6] / p[7], 1, (1 - p[6] - p[7]) / p[7]}; }

// Columns (x, y, z) of each primary; not divided by y, which is 0 for some imaginary primaries.
ColorMatrix columns_of(const Primaries& p) {
    return {p[0], p[2], p[4], p[1], p[3], p[5], 1 - p[0] - p[1], 1 - p[2] - p[3], 1 - p[4] - p[5]};
}

// Scales the responses of Bradford's sharpened cones from one white to the other.
ColorMatrix adapted(const Triple& to_white, const Triple& from_white) {
    static constexpr ColorMatrix cones = {0.8951, 0.2664, -0.1614, -0.7502, 1.7135,
                                          0.0367, 0.0389, -0.0685, 1.0296};
    const Triple to = cones * to_white, from = cones * from_white;
    return inverse(cones) * diagonal({to[0] / from[0], to[1] / from[1], to[2] / from[2]}) * cones;
}

}  // namespace

bool are_usable(const Primaries& primaries) {
    if (!std::ranges::all_of(primaries, [](double v) { return std::abs(v) < 10; })) return false;
    if (!(primaries[7] > 1e-3)) return false;
    const ColorMatrix columns = columns_of(primaries);
    if (!(std::abs(determinant(columns)) > 1e-6)) return false;
    return std::ranges::all_of(inverse(columns) * white_of(primaries),
                               [](double amount) { return amount > 0; });
}

ColorMatrix xyz_from_rgb(const Primaries& primaries) {
    const ColorMatrix columns = columns_of(primaries);
    return columns * diagonal(inverse(columns) * white_of(primaries));
}

ColorMatrix rgb_from_rgb(const Primaries& to, const Primaries& from) {
    if (to == from) return diagonal({1, 1, 1});
    const bool same_white = to[6] == from[6] && to[7] == from[7];
    const ColorMatrix adaptation =
        same_white ? diagonal({1, 1, 1}) : adapted(white_of(to), white_of(from));
    return inverse(xyz_from_rgb(to)) * adaptation * xyz_from_rgb(from);
}

ColorMatrix rec709_from_xyz_d65() { return inverse(xyz_from_rgb(rec709_primaries)); }

}  // namespace splitsum
