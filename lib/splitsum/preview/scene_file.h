#pragma once

#include <filesystem>
#include <string>

#include "splitsum/base/result.h"
#include "splitsum/preview/scene.h"

namespace splitsum {

/// Reads the spheres of a scene from JSON:
///
///     {"spheres": [{"name": "brass", "centre": [0, 0, 0], "radius": 0.45,
///                   "base_color": [0.9, 0.8, 0.4], "metalness": 1, "perceptual_roughness": 0.3}]}
///
/// `centre` is required, in view axes as Sphere has it, within 1e3 of the origin along each axis;
/// `radius` is in (0, 1e3]; the rest is in [0, 1]. What is left out is as in Sphere and Material, and
/// the name is then "sphere" with the place in the list, from 0. At least one sphere, at most
/// most_spheres; names differ.
///
/// Fails with unreadable_input (absent, no JSON: the line is named) or unusable_input: unknown,
/// repeated or missing keys, values of another type or out of range. The message says which sphere,
/// what was found and what would work.
Result<Scene> read_scene(const std::filesystem::path& path);

inline constexpr int most_spheres = 1000;

/// The same of the text of such a file; messages do not name a file.
Result<Scene> parse_scene(const std::string& text);

}  // namespace splitsum
