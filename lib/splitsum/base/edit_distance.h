#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace splitsum {

/// The fewest single-letter insertions, deletions and replacements that turn `from` into `to`
/// (Levenshtein 1966). Cost: from.size() * to.size().
size_t edit_distance(std::string_view from, std::string_view to);

/// The one of `names` that `typed` was probably meant to be: the nearest, the first of several, if
/// no more than a third of the letters of `typed` and one more differ.
std::optional<std::string> nearest_name(std::string_view typed, std::span<const std::string> names);

/// How a message that there is no `typed` goes on: "; did you mean size? There are: size, levels",
/// or without a guess "; there are: size, levels".
std::string names_instead(std::string_view typed, std::span<const std::string> names);

}  // namespace splitsum
