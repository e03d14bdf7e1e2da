#pragma once

#include <filesystem>

#include "splitsum/atlas/atlas.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"

namespace splitsum {

// The cases that are not about one panorama and its levels. Each fails only when cancelled, or where
// a temporary file cannot be written.

/// Values above what each pixel format holds: a row a format.
Result<AtlasEntry> formats_entry(const AtlasPlan& plan, Progress& progress);

/// The largest step between neighbouring texels across edges of the cube over that inside faces, of a
/// smooth sky: a row a method. As figures it has max_rel, that ratio.
Result<AtlasEntry> edges_entry(const AtlasPlan& plan, Progress& progress);

/// Whether 1, 2 and 7 threads give the same bits: a row a method.
Result<AtlasEntry> threads_entry(const AtlasPlan& plan, Progress& progress);

/// How negative short harmonic series of irradiance under a sun get: a row an order.
Result<AtlasEntry> harmonics_entry(const AtlasPlan& plan, Progress& progress);

/// The split sum at n·v from 0 on, for all roughness: a row a method of tables.
Result<AtlasEntry> grazing_entry(const AtlasPlan& plan, Progress& progress);
/// The same at roughness from 0 on, for all n·v.
Result<AtlasEntry> smooth_tables_entry(const AtlasPlan& plan, Progress& progress);

/// Every kind of table at the ends of its axes: a row a kind.
Result<AtlasEntry> table_kinds_entry(const AtlasPlan& plan, Progress& progress);

/// What the reader of panoramas says to files with NaN, odd shapes, cropped windows and damage: a row
/// a file, which is written to `folder` first.
Result<AtlasEntry> files_entry(const AtlasPlan& plan, const std::filesystem::path& folder,
                               Progress& progress);

}  // namespace splitsum
