#pragma once

#include <filesystem>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/sphere/cubemap.h"

namespace splitsum {

/// What a contact sheet shows. The cubemaps must outlive it.
struct ContactSheet {
    struct Level {
        const Cubemap* cubemap;
        double perceptual_roughness;  ///< in [0, 1]: the length of the bar below the level
    };
    std::vector<Level> levels;
    const Cubemap* irradiance = nullptr;  ///< E / pi by normal; may be absent
};

/// The exposure in stops at which `sheet` is shown: that of its first cubemap (exposure.h).
double exposure_stops_of(const ContactSheet& sheet);

/// Writes a picture to look at, 1600 pixels wide: for each level, and last for the irradiance, a
/// ball and the whole sphere as a lat-long strip. The ball of a level mirrors it, as a metal of
/// that roughness would, and faces the middle of the panorama, with left and right as on the strip;
/// that of the irradiance is white and matt. Below each level a bar tells its perceptual roughness. Shown through
/// DisplayTransform::sdr().
///
/// Fails with bad_argument (nothing to show) and unwritable_output.
Status write_contact_sheet(const ContactSheet& sheet, const std::filesystem::path& png);

}  // namespace splitsum
