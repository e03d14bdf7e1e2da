#include "splitsum/atlas/exact_mirror.h"

#include <gtest/gtest.h>

#include "splitsum/atlas/skies.h"
#include "splitsum/measure/error_figures.h"
#include "splitsum/sphere/area_filter.h"

namespace splitsum {
namespace {

// Two ways that share nothing; 4e-6 to 6e-5 was measured.
TEST(ExactMirror, AgreesWithTheAreaFilter) {
    NoProgress progress;
    for (const int face_size : {1, 3, 8})
        for (const auto& make : {gradient_sky, checkerboard_sky, one_texel_sky, lit_poles_sky}) {
            const Environment sky = make(20);
            const auto exact = exact_mirror(sky, face_size, progress);
            const auto filtered = area_filtered_cubemap(sky, face_size, Mat3d(1), progress);
            ASSERT_TRUE(exact && filtered);
            EXPECT_LT(error_figures(exact->texels, filtered->texels).rel_rms, 1e-4) << face_size;
        }
}

// Cubes of one texel a face see each sixth of the sphere; their mean is that of the panorama.
TEST(ExactMirror, KeepsTheMean) {
    NoProgress progress;
    const Environment sky = sun_sky(32, 1e4f);
    const auto exact = exact_mirror(sky, 1, progress);
    ASSERT_TRUE(exact);
    const Vec3d mean = mean_radiance(sky);
    EXPECT_LT(length(mean_radiance(*exact) - mean), 1e-4 * length(mean));
}

}  // namespace
}  // namespace splitsum
