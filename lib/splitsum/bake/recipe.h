#pragma once

#include <string>
#include <utility>
#include <vector>

#include "splitsum/bake/bake.h"
#include "splitsum/base/result.h"
#include "splitsum/color/config_hash.h"
#include "splitsum/panorama/panorama.h"

namespace splitsum {

/// Every option that decides the bytes of what is baked, with its value as text that tells any two
/// values apart, in a fixed order: {"size", "256"}. The names are those of splitsum-bake's options.
/// Of an OpenColorIO config it is what the config says, not where it lies.
///
/// Fails with unreadable_input: the config.
using Settings = std::vector<std::pair<std::string, std::string>>;
Result<Settings> settings_of(const PanoramaOptions& reading, const BakePlan& plan,
                             ConfigHashes& configs);

/// What decides the bytes of everything baked from one panorama, as "xxh3-128:" and 32 hexadecimal
/// digits: name and hash of the source, the settings, and algorithm_version. Equal recipes give
/// equal files, so it is also the key of a cached result. `source_name` is without folders, as files
/// say it.
std::string recipe_of(const std::string& source_name, const std::string& source_hash,
                      const Settings& settings);

/// The same in one step.
Result<std::string> recipe_of(const std::string& source_name, const std::string& source_hash,
                              const PanoramaOptions& reading, const BakePlan& plan,
                              ConfigHashes& configs);

}  // namespace splitsum
