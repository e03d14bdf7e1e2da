#include "splitsum/sphere/area_edges_detail.h"

#include <algorithm>
#include <cmath>

#include "splitsum/base/parallel.h"

namespace splitsum {
namespace {

// Light and solid angle of an area at four places a quarter turn apart.
struct FourAreas {
    FourTurns light{};
    double solid_angle = 0;

    Vec3 mean(size_t turn) const { return Vec3(light[turn] / solid_angle); }
};

// The faces that are the one towards +Z turned 0 to 3 times towards +X.
constexpr std::array<int, 4> side_faces = {4, 0, 5, 1};

// F of whole columns over each quarter turn from the axis on.
FourAreas polar_cap(const AreaGeometry& geometry, const std::vector<FourTurns>& whole_columns) {
    const int quarter = geometry.columns_per_quarter();
    const int first = int(std::floor(geometry.axis()));
    const double cut = geometry.axis() - first;
    FourAreas cap{.solid_angle = 2.0 * quarter};
    for (int i = 0; i <= quarter; ++i) {
        const double weight = i == 0 ? 1 - cut : i == quarter ? cut : 1.0;
        const FourTurns& four = whole_columns[size_t((first + i) % quarter)];
        const int turned = (first + i) / quarter;
        for (int turn = 0; turn < 4; ++turn)
            cap.light[size_t(turn)] += weight * four[size_t(turn + turned) % 4];
    }
    return cap;
}

class HalfCube {
public:
    // `cap` lies between F and the pole of this half: nothing at the upper one.
    HalfCube(const AreaGeometry& geometry, const AreaEdges& edges, const FourAreas& cap,
             Cubemap& cubemap)
        : geometry_(geometry),
          edges_(edges),
          cap_(cap),
          cubemap_(cubemap),
          size_(geometry.face_size()) {}

    void fill() {
        const int first = edges_.lower ? size_ / 2 : 0;
        const int end = edges_.lower ? size_ : size_ / 2;
        parallel_rows(end - first, [&](int i) { fill_side_row(first + i); });
        parallel_rows(size_ / 2, [&](int i) { fill_polar_row(size_ - 1 - i); });
        if (size_ % 2 == 1) fill_middle();
    }

private:
    template <size_t turned>
    void add_edge(FourAreas& area, double sign, int line, int texel) const {
        const AreaLine& of = geometry_.lines()[size_t(line)];
        const size_t i = size_t(texel);
        add_turned<turned>(area.light, sign, edges_.line(line)[i]);
        area.solid_angle += sign * (edges_.lower ? of.from_below[i] : of.from_above[i]);
    }

    // From line to line downwards F grows by what lies between.
    void fill_side_row(int row) {
        const auto line = [&](int j) {
            return AreaGeometry::side_line(edges_.lower ? size_ - j : j);
        };
        for (int x = 0; x < size_; ++x) {
            FourAreas area;
            add_edge<0>(area, 1, line(row + 1), x);
            if (edges_.lower && row == size_ / 2)
                add_equator(area, x);
            else
                add_edge<0>(area, -1, line(row), x);
            for (size_t turn = 0; turn < 4; ++turn)
                cubemap_.at(side_faces[turn], x, row) = area.mean(turn);
        }
    }

    void add_equator(FourAreas& area, int x) const {
        const AreaLine& of = geometry_.lines()[size_t(AreaGeometry::side_line(size_ / 2))];
        add_turned<0>(area.light, -1, edges_.equator[size_t(x)]);
        area.solid_angle -= of.from_above[size_t(x)];
    }

    // The texels ahead of the pole (towards +Z) and to its right (towards +X), and their turned
    // copies. `z` and `x` count texels towards +Z and +X.
    void fill_polar_row(int z) {
        for (int x = size_ / 2; x < size_; ++x) {
            FourAreas area = around_polar_texel(x, z);
            if (2 * x == size_ && 2 * z == size_) add_turned_cap<0>(area);
            for (int turn = 0, i = x, k = z; turn < 4; ++turn) {
                polar_texel(i, k) = area.mean(size_t(turn));
                const int ahead = k;
                k = size_ - 1 - i;
                i = ahead;
            }
        }
    }

    // Lines further from the pole add and nearer ones subtract. In the lower half F is that of the
    // whole column less what lies beyond, so that signs change.
    FourAreas around_polar_texel(int x, int z) const {
        const double sign = edges_.lower ? -1 : 1;
        const int last = size_ - 1;
        FourAreas area;
        add_edge<0>(area, sign, geometry_.polar_line(last - z), x);
        add_edge<1>(area, sign, geometry_.polar_line(last - x), last - z);
        if (2 * z > size_) add_edge<0>(area, -sign, geometry_.polar_line(size_ - z), x);
        if (2 * x > size_) add_edge<1>(area, -sign, geometry_.polar_line(size_ - x), last - z);
        if (2 * x < size_)  // in the middle of an odd face: that line is beyond the pole
            add_edge<3>(area, sign, geometry_.polar_line(x), z);
        return area;
    }

    // The texel around the pole of a face whose size is odd.
    void fill_middle() {
        const int middle = size_ / 2, line = geometry_.polar_line(middle);
        const double sign = edges_.lower ? -1 : 1;
        FourAreas area;
        add_edge<0>(area, sign, line, middle), add_turned_cap<0>(area);
        add_edge<1>(area, sign, line, middle), add_turned_cap<1>(area);
        add_edge<2>(area, sign, line, middle), add_turned_cap<2>(area);
        add_edge<3>(area, sign, line, middle), add_turned_cap<3>(area);
        polar_texel(middle, middle) = area.mean(0);
    }

    template <size_t turned>
    void add_turned_cap(FourAreas& area) const {
        add_turned<turned>(area.light, 1, cap_.light);
        area.solid_angle += cap_.solid_angle;
    }

    Vec3& polar_texel(int x, int z) {
        return edges_.lower ? cubemap_.at(3, x, size_ - 1 - z) : cubemap_.at(2, x, z);
    }

    const AreaGeometry& geometry_;
    const AreaEdges& edges_;
    const FourAreas& cap_;
    Cubemap& cubemap_;
    int size_;
};

}  // namespace

void AreaEdges::start_lower_half() {
    const FourTurns* last = line(AreaGeometry::side_line(int(texels) / 2));
    std::copy_n(last, texels, equator.begin());
    std::ranges::fill(lines, FourTurns{});
    lower = true;
}

void fill_upper_half(const AreaGeometry& geometry, const AreaEdges& edges, Cubemap& cubemap) {
    HalfCube(geometry, edges, {}, cubemap).fill();
}

void fill_lower_half(const AreaGeometry& geometry, const AreaEdges& edges,
                     const std::vector<FourTurns>& whole_columns, Cubemap& cubemap) {
    HalfCube(geometry, edges, polar_cap(geometry, whole_columns), cubemap).fill();
}

}  // namespace splitsum
