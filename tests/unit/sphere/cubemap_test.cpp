#include "splitsum/sphere/cubemap.h"

#include <gtest/gtest.h>

#include <numbers>

namespace splitsum {
namespace {

TEST(Cubemap, SolidAnglesCoverTheSphere) {
    for (const int size : {1, 2, 7, 64}) {
        double sum = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) sum += face_count * solid_angle_of_texel(x, y, size);
        EXPECT_NEAR(sum, 4 * std::numbers::pi, 1e-11) << "size " << size;
    }
}

TEST(Cubemap, DirectionsAreThoseOfTheVulkanFaceTable) {
    // The middle of each face, and where its right and its lower edge lead.
    struct Row {
        Vec3d middle, right, down;
    };
    const Row rows[] = {{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                        {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                        {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}};
    for (int face = 0; face < face_count; ++face) {
        const Row& row = rows[face];
        EXPECT_NEAR(length(direction_on_face(face, 0.5, 0.5) - row.middle), 0, 1e-15);
        EXPECT_NEAR(length(direction_on_face(face, 1, 0.5) - normalize(row.middle + row.right)), 0,
                    1e-15);
        EXPECT_NEAR(length(direction_on_face(face, 0.5, 1) - normalize(row.middle + row.down)), 0,
                    1e-15);
    }
}

TEST(Cubemap, FacePointsInvertDirections) {
    for (int face = 0; face < face_count; ++face)
        for (const double s : {0.001, 0.3, 0.77})
            for (const double t : {0.02, 0.5, 0.999}) {
                const FacePoint point = face_point_towards(3.0 * direction_on_face(face, s, t));
                EXPECT_EQ(point.face, face);
                EXPECT_NEAR(point.s, s, 1e-14);
                EXPECT_NEAR(point.t, t, 1e-14);
            }
}

}  // namespace
}  // namespace splitsum
