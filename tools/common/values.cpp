#include "common/values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
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
