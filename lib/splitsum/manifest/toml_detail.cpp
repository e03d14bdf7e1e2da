#include <algorithm>

#include <toml++/toml.h>

#include "splitsum/manifest/notations_detail.h"

namespace splitsum {
namespace {

using Kind = ManifestValue::Kind;

// Tables that only dotted keys imply have no line of their own.
int line_of_node(const toml::node& node, int line_of_parent) {
    const auto line = static_cast<int>(node.source().begin.line);
    return line > 0 ? line : line_of_parent;
}

ManifestValue value_of(const toml::node& node, int line_of_parent) {
    const int line = line_of_node(node, line_of_parent);
    if (const auto* whole = node.as_integer()) return whole_value(whole->get(), line);
    if (const auto* number = node.as_floating_point()) return number_value(number->get(), line);
    if (const auto* text = node.as_string()) return text_value(text->get(), line);
    ManifestValue value;
    value.line = line;
    if (const auto* flag = node.as_boolean()) {
        value.kind = Kind::flag;
        value.text = flag->get() ? "true" : "false";
    } else if (const auto* list = node.as_array()) {
        value.kind = Kind::list;
        for (const toml::node& item : *list) value.items.push_back(value_of(item, line));
    } else if (const auto* table = node.as_table()) {
        for (const auto& [key, member] : *table) {
            value.items.push_back(value_of(member, line));
            value.items.back().key = key.str();
        }
        std::ranges::sort(value.items, {}, &ManifestValue::key);
    } else {
        value.kind = Kind::other;
        value.text = "a date or time";
    }
    return value;
}

}  // namespace

ParsedText parse_toml(std::string_view text) {
    ParsedText parsed;
    try {
        parsed.root = value_of(toml::parse(text), 1);
    } catch (const toml::parse_error& error) {
        parsed.problem = TextProblem{static_cast<int>(error.source().begin.line),
                                     std::string(error.description())};
    }
    return parsed;
}

}  // namespace splitsum
