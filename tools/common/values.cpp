#include "common/values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

// The number that the whole of `text` spells, if any.
template <class Number>
std::optional<Number> parse_number(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    Number number{};
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

bool is_whole_number(const std::string& text, int64_t lowest, int64_t highest) {
    const auto number = parse_number<int64_t>(text);
    return number && *number >= lowest && *number <= highest;
}

constexpr std::string_view units = "KMGT";

// The bytes that "600M" stands for; nothing where they are no size or more than an int64_t holds.
std::optional<int64_t> parse_bytes(std::string_view text) {
    size_t unit = 0;
    if (!text.empty() && units.find(text.back()) != units.npos) {
        unit = units.find(text.back()) + 1;
        text.remove_suffix(1);
    }
    const auto number = parse_number<int64_t>(text);
    const int64_t factor = int64_t(1) << (10 * unit);
    if (!number || text.starts_with('-') || *number > std::numeric_limits<int64_t>::max() / factor)
        return std::nullopt;
    return *number * factor;
}

}  // namespace

CLI::Validator whole_number(int64_t lowest, int64_t highest) {
    return CLI::Validator(
        [=](std::string& text) -> std::string {
            if (is_whole_number(text, lowest, highest)) return {};
            return cat("'", text, "' is not a whole number from ", lowest, " to ", highest);
        },
        "");
}

CLI::Validator whole_number_or_auto(int64_t lowest, int64_t highest) {
    return CLI::Validator(
        [=](std::string& text) -> std::string {
            if (text == "auto" || is_whole_number(text, lowest, highest)) return {};
            return cat("'", text, "' is neither auto nor a whole number from ", lowest, " to ",
                       highest);
        },
        "");
}

CLI::Validator finite_number(double lowest, double highest) {
    return CLI::Validator(
        [=](std::string& text) -> std::string {
            const auto number = parse_number<double>(text);
            // Written so that NaN fails too.
            if (number && *number >= lowest && *number <= highest) return {};
            return cat("'", text, "' is not a number from ", lowest, " to ", highest);
        },
        "");
}

CLI::Validator byte_count(int64_t lowest, int64_t highest) {
    return CLI::Validator(
        [=](std::string& text) -> std::string {
            const auto bytes = parse_bytes(text);
            if (!bytes || *bytes < lowest || *bytes > highest)
                return cat("'", text, "' is not a size from ", byte_count_text(lowest), " to ",
                           byte_count_text(highest),
                           ": a whole number of bytes, or one with K, M, G or T behind it");
            text = std::to_string(*bytes);
            return {};
        },
        "");
}

std::string byte_count_text(int64_t bytes) {
    size_t unit = 0;
    for (; unit < units.size() && bytes != 0 && bytes % 1024 == 0; ++unit) bytes /= 1024;
    return unit == 0 ? cat(bytes) : cat(bytes, units[unit - 1]);
}

CLI::Validator not_empty() {
    return CLI::Validator(
        [](std::string& text) -> std::string {
            return text.empty() ? "the value is empty; a name is needed" : "";
        },
        "");
}

CLI::Validator one_of(const std::vector<Choice>& choices) {
    return CLI::Validator(
        [choices](std::string& text) -> std::string {
            if (std::ranges::find(choices, std::string_view(text), &Choice::name) != choices.end())
                return {};
            return cat("there is no '", text, "'; there are: ",
                       join(choices, ", ", [](const Choice& c) { return c.name; }));
        },
        "");
}

std::string help_of(std::span<const Choice> choices) {
    return join(choices, "\n",
                [](const Choice& choice) { return cat("  ", choice.name, ": ", choice.summary); });
}

}  // namespace splitsum::tools
