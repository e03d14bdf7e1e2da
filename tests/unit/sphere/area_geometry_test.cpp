#include "splitsum/sphere/area_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "splitsum/sphere/orientation.h"

namespace splitsum {
namespace {

AreaGeometry geometry_of(int height, int face_size) {
    return AreaGeometry(height, face_size, panorama_from_cube({17.3, false, "ktx"}));
}

// Each line covers the azimuths between its ends, and what covers them are multiples of 2^-24: the
// sum has no rounding in it.
TEST(AreaGeometry, TheNodesOfALineCoverItsAzimuthsExactly) {
    for (const int height : {1, 33, 300})
        for (const int size : {1, 2, 9, 32}) {
            const AreaGeometry geometry = geometry_of(height, size);
            ASSERT_EQ(geometry.lines().size(), size_t(size));
            const auto azimuths = [&](int line) {
                double sum = 0;
                for (const AreaArc& arc : geometry.lines()[size_t(line)].arcs)
                    for (const AreaNode& node : arc.nodes) {
                        EXPECT_EQ(std::fmod(node.weight, 0x1p-24), 0);
                        sum += node.weight;
                    }
                return sum;
            };
            for (int j = 0; j <= size / 2; ++j)
                EXPECT_EQ(azimuths(AreaGeometry::side_line(j)), geometry.columns_per_quarter());
            for (int j = 1; 2 * j < size; ++j)
                EXPECT_NEAR(azimuths(geometry.polar_line(j)),
                            2 * std::atan(size / (size - 2.0 * j)) * 2 / std::numbers::pi *
                                geometry.columns_per_quarter(),
                            1e-6);
        }
}

TEST(AreaGeometry, RowsNeverDecreaseAlongAnArcAndStayInTheUpperHalf) {
    for (const int height : {1, 2, 33, 300}) {
        const AreaGeometry geometry = geometry_of(height, 12);
        for (const AreaLine& line : geometry.lines())
            for (const AreaArc& arc : line.arcs) {
                uint32_t row = 0;
                for (const AreaRun& run : arc.runs) {
                    ASSERT_GE(run.row, row);
                    row = run.row;
                }
                ASSERT_LE(int(row), (height - 1) / 2);
                ASSERT_EQ(arc.runs.back().end, arc.nodes.size());
            }
    }
}

// Four edges between a side face and the polar one enclose one sixth of the sphere.
TEST(AreaGeometry, TheSolidAngleAboveAFacesEdgeIsThatOfAFace) {
    for (const int height : {1, 50, 512})
        for (const int size : {1, 4, 31}) {
            const AreaGeometry geometry = geometry_of(height, size);
            double above = 0;
            for (const double angle : geometry.lines().front().from_above) above += angle;
            const double columns_per_radian = 2 * geometry.columns_per_quarter() / std::numbers::pi;
            EXPECT_NEAR(4 * above / columns_per_radian, 4 * std::numbers::pi / 6, 3e-8)
                << height << " rows, size " << size;
        }
}

}  // namespace
}  // namespace splitsum
