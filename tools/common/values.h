#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace splitsum::tools {

/// Accepts whole decimal numbers from `lowest` to `highest` and nothing else: no fractions, no
/// trailing letters, no wrap-around.
CLI::Validator whole_number(int64_t lowest, int64_t highest);

/// Accepts the same, and the word "auto".
CLI::Validator whole_number_or_auto(int64_t lowest, int64_t highest);

/// Accepts finite decimal numbers from `lowest` to `highest`.
CLI::Validator finite_number(double lowest, double highest);

/// Accepts sizes from `lowest` to `highest` bytes and, given to transform() of an option, replaces
/// them with the number of bytes: a whole number, alone or with K, M, G or T behind it for powers
/// of 1024. "600M" is 629145600.
CLI::Validator byte_count(int64_t lowest, int64_t highest);

/// How --help names such a value.
inline constexpr const char* byte_count_name = "BYTES[K|M|G|T]";

/// A size in the fewest digits that byte_count() reads back to it: "600M", "1000", "1".
std::string byte_count_text(int64_t bytes);

/// Accepts every text but the empty one.
CLI::Validator not_empty();

/// One of the values an option can take.
struct Choice {
    std::string_view name;
    std::string_view summary;  ///< one line for --help
};

/// The rows of a table whose elements have a `name` and a `summary`, as choices.
template <class Table>
std::vector<Choice> choices_of(const Table& table) {
    std::vector<Choice> choices;
    for (const auto& row : table) choices.push_back({row.name, row.summary});
    return choices;
}

/// Accepts the names of `choices`; refusing, it lists them.
CLI::Validator one_of(const std::vector<Choice>& choices);

/// The choices as --help shows them: one a line, name and summary.
std::string help_of(std::span<const Choice> choices);

}  // namespace splitsum::tools
