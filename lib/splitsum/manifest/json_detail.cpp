#include <algorithm>
#include <charconv>
#include <memory>

#include <json/json.h>

#include "splitsum/base/text.h"
#include "splitsum/manifest/notations_detail.h"

namespace splitsum {
namespace {

using Kind = ManifestValue::Kind;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Without the digits that `text` begins with; nothing if there are none.
std::optional<std::string_view> behind_digits(std::string_view text) {
    size_t digits = 0;
    while (digits < text.size() && is_digit(text[digits])) ++digits;
    if (digits == 0) return std::nullopt;
    return text.substr(digits);
}

// Whether `text` is a number by the grammar of RFC 8259. JsonCpp also takes 01, 1. and +1.
bool is_json_number(std::string_view text) {
    if (text.starts_with('-')) text.remove_prefix(1);
    const bool begins_with_zero = text.starts_with('0');
    auto rest = behind_digits(text);
    if (!rest || (begins_with_zero && text.size() - rest->size() > 1)) return false;
    if (rest->starts_with('.') && !(rest = behind_digits(rest->substr(1)))) return false;
    if (rest->starts_with('e') || rest->starts_with('E')) {
        rest->remove_prefix(1);
        if (rest->starts_with('+') || rest->starts_with('-')) rest->remove_prefix(1);
        rest = behind_digits(*rest);
    }
    return rest && rest->empty();
}

// Turns what JsonCpp read into ManifestValue, and its byte offsets into lines.
class Converter {
public:
    explicit Converter(std::string_view text) : text_(text) {
        for (size_t i = 0; i < text.size(); ++i)
            if (text[i] == '\n') line_ends_.push_back(i);
    }

    ManifestValue value_of(const Json::Value& json) const {
        const int line = line_of_value(json);
        if (json.isString()) return text_value(json.asString(), line);
        if (json.isNumeric() && !json.isBool()) return number_of(source_of(json), json, line);
        ManifestValue value;
        value.line = line;
        if (json.isBool()) {
            value.kind = Kind::flag;
            value.text = json.asBool() ? "true" : "false";
        } else if (json.isArray()) {
            value.kind = Kind::list;
            for (const Json::Value& item : json) value.items.push_back(value_of(item));
        } else if (json.isObject()) {
            value.items = members_of(json);
        } else {
            value.kind = Kind::other;
            value.text = "null";
        }
        return value;
    }

private:
    int line_of_value(const Json::Value& json) const {
        const auto offset = static_cast<size_t>(json.getOffsetStart());
        return 1 +
               static_cast<int>(std::ranges::lower_bound(line_ends_, offset) - line_ends_.begin());
    }

    std::string_view source_of(const Json::Value& json) const {
        const auto begin = static_cast<size_t>(json.getOffsetStart());
        return text_.substr(begin, static_cast<size_t>(json.getOffsetLimit()) - begin);
    }

    static ManifestValue number_of(std::string_view source, const Json::Value& json, int line) {
        ManifestValue value;
        value.kind = Kind::other;
        value.line = line;
        value.text = cat(source, ", which is not how JSON writes numbers");
        if (!is_json_number(source)) return value;
        if (source.find_first_of(".eE") != std::string_view::npos)
            return number_value(json.asDouble(), line);
        if (json.isInt64()) return whole_value(json.asInt64(), line);
        value.text = cat(source, ", a whole number beyond 2^53");
        return value;
    }

    std::vector<ManifestValue> members_of(const Json::Value& json) const {
        std::vector<ManifestValue> members;
        for (auto member = json.begin(); member != json.end(); ++member) {
            members.push_back(value_of(*member));
            members.back().key = member.name();
        }
        std::ranges::sort(members, {}, &ManifestValue::key);
        return members;
    }

    std::string_view text_;
    std::vector<size_t> line_ends_;
};

// JsonCpp takes comments inside objects and lists whether it shall or not.
std::optional<size_t> first_comment(std::string_view json) {
    bool in_text = false;
    for (size_t i = 0; i < json.size(); ++i) {
        if (json[i] == '"')
            in_text = !in_text;
        else if (in_text && json[i] == '\\')
            ++i;
        else if (!in_text && json[i] == '/')
            return i;
    }
    return std::nullopt;
}

// JsonCpp says "* Line 3, Column 5\n  What is wrong.\n", perhaps several times: what follows the
// first is its consequence.
TextProblem first_problem(std::string_view messages) {
    constexpr std::string_view before_line = "* Line ";
    constexpr std::string_view before_text = "\n  ";
    TextProblem problem;
    if (messages.starts_with(before_line))
        std::from_chars(messages.data() + before_line.size(), messages.data() + messages.size(),
                        problem.line);
    const size_t begin = messages.find(before_text);
    if (begin != std::string_view::npos) messages.remove_prefix(begin + before_text.size());
    problem.text = messages.substr(0, messages.find('\n'));
    return problem;
}

}  // namespace

ParsedText parse_json(std::string_view text) {
    Json::CharReaderBuilder strict;
    Json::CharReaderBuilder::strictMode(&strict.settings_);
    const std::unique_ptr<Json::CharReader> reader(strict.newCharReader());
    ParsedText parsed;
    Json::Value root;
    std::string messages;
    bool readable = false;
    try {
        readable = reader->parse(text.data(), text.data() + text.size(), &root, &messages);
    } catch (const Json::Exception& failure) {  // deeper than JsonCpp goes
        messages = failure.what();
    }
    if (!readable) {
        parsed.problem = first_problem(messages);
    } else if (const auto comment = first_comment(text)) {
        parsed.problem = TextProblem{line_of(text, *comment), "JSON has no comments; TOML has"};
    } else if (!root.isObject()) {
        parsed.problem = TextProblem{1, "a manifest is an object: { \"panoramas\": [...] }"};
    } else {
        parsed.root = Converter(text).value_of(root);
    }
    return parsed;
}

}  // namespace splitsum
