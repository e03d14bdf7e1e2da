#include "splitsum/manifest/value_detail.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "splitsum/base/text.h"
#include "splitsum/manifest/problems_detail.h"
#include "splitsum/manifest/source_text_detail.h"

namespace splitsum {
namespace {

using Kind = ManifestValue::Kind;

ManifestValue value_of(Kind kind, int line, std::string text) {
    ManifestValue value;
    value.kind = kind;
    value.line = line;
    value.text = std::move(text);
    return value;
}

}  // namespace

ManifestValue whole_value(int64_t number, int line) {
    constexpr int64_t largest = int64_t{1} << 53;
    if (number > largest || number < -largest)
        return value_of(Kind::other, line, cat(number, ", a whole number beyond 2^53"));
    return value_of(Kind::number, line, std::to_string(number));
}

ManifestValue number_value(double number, int line) {
    if (!std::isfinite(number)) return value_of(Kind::other, line, cat(number, ", not a number"));
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
    return value_of(Kind::number, line, {buffer.data(), end});
}

ManifestValue text_value(std::string text, int line) {
    const bool usable = !first_bad_byte(text) && text.find_first_of("\n\r\t") == std::string::npos;
    if (!usable) return value_of(Kind::other, line, "text with control characters");
    return value_of(Kind::text, line, std::move(text));
}

std::string description_of(const ManifestValue& value) {
    switch (value.kind) {
        case Kind::flag:
        case Kind::number:
        case Kind::other: return value.text;
        case Kind::text: return value.text.empty() ? "empty text" : in_quotes(value.text);
        case Kind::list: return value.items.empty() ? "an empty list" : "a list";
        case Kind::table: return "a table";
    }
    return "";
}

}  // namespace splitsum
