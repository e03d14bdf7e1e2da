#pragma once

#include <map>
#include <string_view>
#include <utility>

#include "support/skies.h"

namespace splitsum::benchmarks {

/// The sky at this resolution, made when it is first asked for and kept. From one thread only.
inline const Environment& sky_made_once(const tests::NamedSky& sky, int height) {
    static std::map<std::pair<std::string_view, int>, Environment> made;
    const std::pair key(sky.name, height);
    const auto found = made.find(key);
    if (found != made.end()) return found->second;
    return made.emplace(key, sky.make(height)).first->second;
}

}  // namespace splitsum::benchmarks
