#include "splitsum/preview/auto_exposure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "splitsum/picture/exposure.h"

namespace splitsum {
namespace {

Cubemap constant(float radiance) {
    Cubemap cubemap(4);
    for (Vec3& texel : cubemap.texels) texel = Vec3(radiance);
    return cubemap;
}

TEST(AutoExposure, OfEvenLightIsThatOfContactSheets) {
    for (const float radiance : {1e-3f, 0.25f, 40.0f})
        EXPECT_EQ(auto_exposure_stops(constant(radiance)), exposure_stops_of(constant(radiance)));
}

TEST(AutoExposure, DoesNotBleachWhatLampsShineOn) {
    Cubemap lamps = constant(1e-4f);
    lamps.at(2, 1, 3) = Vec3(100, 50, 0);
    const double stops = auto_exposure_stops(lamps);
    const Vec3d mean = std::exp2(stops) * mean_radiance(lamps);
    EXPECT_LT(stops, exposure_stops_of(lamps));
    EXPECT_NEAR(0.2126 * mean.x + 0.7152 * mean.y + 0.0722 * mean.z, 0.4, 1e-6);
}

TEST(AutoExposure, FollowsTheLight) {
    Cubemap sky = constant(0.1f);
    sky.at(0, 0, 0) = Vec3(3, 2, 1);
    Cubemap brighter = sky;
    for (Vec3& texel : brighter.texels) texel *= 8.0f;
    EXPECT_NEAR(auto_exposure_stops(brighter), auto_exposure_stops(sky) - 3, 1e-6);
    EXPECT_EQ(auto_exposure_stops(constant(0)), 0);
}

}  // namespace
}  // namespace splitsum
