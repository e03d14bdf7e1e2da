#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/container/containers.h"
#include "splitsum/library/outcome.h"
#include "splitsum/plan/table_plan.h"

namespace splitsum {

/// The file of the table that all panoramas of a library share, in the library's folder.
inline constexpr const char* library_table_file = "brdf.ktx2";

/// Which table that is, and how it is stored. Pure data: equal tables give equal bytes.
struct LibraryTable {
    TablePlan plan;
    ContainerOptions container;
};

/// Fails with bad_argument: what was asked, and what would work. A closed form is no texture.
Status validate(const LibraryTable& table);

/// What is there of the table, or was done about it.
struct TableResult {
    Outcome outcome = Outcome::not_begun;
    std::string why;  ///< why it was or has to be baked, a half sentence
    std::filesystem::path file;
    int64_t bytes = 0;
    double max_abs = 0;  ///< measured when it was baked, at texels
};

/// Whether the table in `folder` is the one that this version would bake: up_to_date, or not_begun
/// and why. The file says so itself, by the keys splitsum.recipe (a hash of the table's options and
/// algorithm_version) and splitsum.hash (of its texels and keys). Cost: reads and hashes the file.
TableResult find_library_table(const LibraryTable& table, const std::filesystem::path& folder);

/// Bakes the table into `folder`, which must exist; the file appears whole or not at all. Fails as
/// bake_table and write_texture do.
Result<TableResult> bake_library_table(const LibraryTable& table,
                                       const std::filesystem::path& folder, Progress& progress);

}  // namespace splitsum
