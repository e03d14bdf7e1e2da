#pragma once

#include <optional>
#include <span>
#include <string>

#include "splitsum/manifest/manifest.h"
#include "splitsum/manifest/settings_detail.h"

namespace splitsum {

/// What the table of a panorama may hold beside settings.
std::span<const std::string> panorama_keys();

/// One element of `panoramas` in the manifest `file`: a table, or text, which is its file. Without
/// the defaults. Nothing where the problems say why.
std::optional<ManifestPanorama> panorama_of(const ManifestValue& entry,
                                            const std::filesystem::path& file,
                                            const SettingReader& settings, Problems& problems);

/// Adds a problem for each panorama whose results would be written over those of an earlier one: it
/// has the same name or, where it has none, stem. Folders are left out: what they hold decides.
void check_distinct(std::span<const ManifestPanorama> panoramas, Problems& problems);

}  // namespace splitsum
