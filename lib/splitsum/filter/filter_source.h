#pragma once

#include "splitsum/filter/spectrum.h"
#include "splitsum/sphere/environment.h"

namespace splitsum {

/// The light to be filtered.
struct FilterSource {
    FilterSource(const Environment& light, const Spectrum* exact = nullptr)
        : environment(light), spectrum(exact) {}

    const Environment& environment;
    /// Of the light itself, where `environment` is an average of it (a large panorama that was
    /// streamed); null where the environment is the light.
    const Spectrum* spectrum;
};

}  // namespace splitsum
