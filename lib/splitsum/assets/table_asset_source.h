#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "splitsum/assets/table_asset.h"
#include "splitsum/base/result.h"

namespace splitsum {

/// One kind of text file that holds a table, for programs that compile or parse it.
struct TableSource {
    std::string_view extension;  ///< with its dot, in lower case
    std::string_view summary;    ///< one line for --help
    int most_texels;             ///< of a layer; what compilers bear
    std::string (*text)(const TableAsset& asset);
};

/// Every kind; one line each:
/// .hpp:  a header of C++17 without dependencies: the numbers, their meaning, and a lookup function
///        that is the bilinear filter of a sampler;
/// .glsl: the same for GLSL 4.50 and ES 3.00, up to 64 x 64 texels;
/// .json: the numbers with everything the metadata says.
/// A closed form is written as its formula. Floats are written so that they read back exactly.
std::span<const TableSource> table_sources();

/// The kind with the extension of `path`, in upper or lower case, or nullptr.
const TableSource* table_source_of(const std::filesystem::path& path);

/// Writes the asset in the form that the extension of `path` asks for, whole or not at all. Fails
/// with bad_argument (another extension, too many texels) and unwritable_output.
Status write_table_source(const TableAsset& asset, const std::filesystem::path& path);

}  // namespace splitsum
