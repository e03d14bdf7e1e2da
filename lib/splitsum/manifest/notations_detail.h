#pragma once

#include <optional>
#include <string_view>

#include "splitsum/manifest/source_text_detail.h"
#include "splitsum/manifest/value_detail.h"

namespace splitsum {

/// The tree of a text, or what is wrong with its syntax.
struct ParsedText {
    ManifestValue root;  ///< a table
    std::optional<TextProblem> problem;
};

/// TOML 1.0, by toml++. Dates and times become `other`.
ParsedText parse_toml(std::string_view text);

/// JSON (RFC 8259), by JsonCpp, without repeated keys. null becomes `other`.
ParsedText parse_json(std::string_view text);

}  // namespace splitsum
