// Rows 7 and 8: the poles of the panorama, the edges and corners of the cube.
#include <algorithm>

#include "stability/levels.h"
#include "support/lopsided_sky.h"

namespace splitsum::tests {
namespace {

constexpr int size = 16;
const std::vector<double> roughness = {0, 0.15, 0.4, 1};

class Smoothness : public EveryReflectionMethod {};
INSTANTIATE_TEST_SUITE_P(Methods, Smoothness, testing::ValuesIn(reflection_methods()));

// The texel beside (x, y), on the next face where the edge lies between.
Vec3 neighbour(const Cubemap& level, int face, int x, int y) {
    const Vec3d d = direction_on_face(face, (x + 0.5) / size, (y + 0.5) / size);
    const FacePoint at = face_point_towards(d);
    return level.at(at.face, std::min(int(at.s * size), size - 1),
                    std::min(int(at.t * size), size - 1));
}

struct Steps {
    float inside = 0;  ///< the largest difference of neighbours within a face
    float across = 0;  ///< the same across the cube's edges
};

Steps steps_of(const Cubemap& level) {
    Steps steps;
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                    const int to_x = x + dx, to_y = y + dy;
                    const bool leaves = to_x < 0 || to_y < 0 || to_x == size || to_y == size;
                    const float step =
                        length(level.at(face, x, y) - neighbour(level, face, to_x, to_y));
                    float& largest = leaves ? steps.across : steps.inside;
                    largest = std::max(largest, step);
                }
    return steps;
}

TEST_P(Smoothness, OfASmoothSkyGoesOverTheEdges) {
    for (const auto& level : levels_by(GetParam(), lopsided_sky(64, 0), roughness, size)) {
        const Steps steps = steps_of(level);
        EXPECT_GT(steps.inside, 1e-3f);
        EXPECT_LE(steps.across, steps.inside);
    }
}

// The test above sees a face that is a hundredth too bright.
TEST(SmoothnessItself, NoticesASeam) {
    Cubemap level = levels_by("reference", lopsided_sky(64, 0), {0.4}, size)[0];
    for (int y = 0; y < size; ++y)
        for (Vec3& texel : level.row(4, y)) texel *= 1.05f;
    const Steps steps = steps_of(level);
    EXPECT_GT(steps.across, steps.inside);
}

// How far a texel is from the mean of its four neighbours, at most, where `counts` says so.
template <class Counts>
float roughest(const Cubemap& level, const Counts& counts) {
    float largest = 0;
    for (const int face : {2, 3})
        for (int y = 1; y + 1 < size; ++y)
            for (int x = 1; x + 1 < size; ++x) {
                if (!counts(x, y)) continue;
                const Vec3 mean = 0.25f * (level.at(face, x - 1, y) + level.at(face, x + 1, y) +
                                           level.at(face, x, y - 1) + level.at(face, x, y + 1));
                largest = std::max(largest, length(level.at(face, x, y) - mean));
            }
    return largest;
}

// No dot and no star where the panorama's rows shrink to a point: the middle of the +Y and -Y faces
// is as smooth as the rest of them, or varies by less than 1/1000 of the light.
TEST_P(Smoothness, OfASmoothSkyGoesOverThePoles) {
    const auto levels = levels_by(GetParam(), lopsided_sky(64, 0), roughness, size);
    for (size_t i = 0; i < levels.size(); ++i) {
        const auto near_pole = [](int x, int y) {
            return std::hypot(x + 0.5 - size / 2, y + 0.5 - size / 2) < 3;
        };
        const float at_pole = roughest(levels[i], near_pole);
        const float elsewhere = roughest(levels[i], [&](int x, int y) { return !near_pole(x, y); });
        EXPECT_LE(at_pole, std::max(1.5f * elsewhere, 2e-3f)) << "r " << roughness[i];
    }
}

}  // namespace
}  // namespace splitsum::tests
