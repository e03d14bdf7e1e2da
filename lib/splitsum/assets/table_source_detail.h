#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

#include "splitsum/assets/table_asset.h"

namespace splitsum {

/// A float with the fewest digits that read back to it, always with a point or an exponent, so that
/// no language takes it for a whole number.
std::string float_text(float value);

/// The name that generated code uses: "splitsum_ggx_multiscatter".
std::string identifier_of(const TableKind& kind);

/// What the metadata says as comment lines, one a key.
std::string metadata_comment(const TableAsset& asset);

std::string table_as_cpp(const TableAsset& asset);
std::string table_as_glsl(const TableAsset& asset);

/// A closed form's coefficients, and its code in both languages.
nlohmann::ordered_json formula_json(const TableAsset& asset);
std::string formula_as_cpp(const TableAsset& asset);
std::string formula_as_glsl(const TableAsset& asset);

}  // namespace splitsum
