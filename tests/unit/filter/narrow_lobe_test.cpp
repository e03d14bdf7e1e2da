#include "splitsum/filter/narrow_lobe.h"

#include <gtest/gtest.h>

#include "splitsum/filter/texel_quadrature.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

// share * wide + rest is the narrow lobe, whatever the environment.
TEST(NarrowLobe, ItsPartsAddUpToTheLobe) {
    const Environment sky = tests::lopsided_sky(128);
    const TexelQuadrature exact(sky, 25), quick(sky, 4);
    const auto average = [&](double alpha, const Vec3d& d) {
        const Lobe lobe{LobeKind::ggx, alpha};
        return exact.over_hemisphere(lobe, d) / lobe_integral(lobe);
    };
    const Vec3d directions[] = {normalize(Vec3d(0.41, 0.5, -0.69)),
                                {0, 1, 0},
                                normalize(Vec3d(-0.3, 0.2, -0.9)),
                                {0, 0, -1}};
    for (const double alpha : {1e-6, 1e-3, 0.005, 0.02}) {
        const NarrowLobe narrow(alpha, 0.04, 1e-5);
        for (const Vec3d& d : directions) {
            const Vec3d whole = average(alpha, d);
            const Vec3d sum = narrow.share() * average(0.04, d) + narrow.rest(quick, d);
            EXPECT_LT(length(sum - whole), 2e-4 * length(whole)) << "alpha " << alpha;
        }
    }
}

}  // namespace
}  // namespace splitsum
