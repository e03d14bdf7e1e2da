#pragma once

#include <optional>
#include <string_view>

namespace splitsum {

/// The first byte of TOML or JSON text at which lists and tables are nested deeper than 32 or a
/// key has more than 16 parts (a.b.c has 3), if there is one. toml++ makes a table in a table for
/// each part without a limit, and taking a million of them down again overflows the stack.
///
/// Follows strings and comments as TOML has them; JSON's strings are a part of that, and it has no
/// other quotes or comments. Of text that is neither, whatever is found first is returned.
std::optional<size_t> first_too_deep(std::string_view text);

}  // namespace splitsum
