#include "splitsum/manifest/nesting_detail.h"

namespace splitsum {
namespace {

constexpr int deepest = 32;
constexpr int most_parts = 16;

// Behind the string that begins at `i`: 'a', "a" with escapes, '''a''' or """a""" with escapes. One
// that does not end, or not on its line, ends with the text or the line: parsers refuse it.
size_t behind_string(std::string_view text, size_t i) {
    const char quote = text[i];
    const std::string_view three = quote == '"' ? "\"\"\"" : "'''";
    const bool spans_lines = text.substr(i, 3) == three;
    i += spans_lines ? 3 : 1;
    for (; i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"') {
            ++i;
        } else if (spans_lines) {
            if (text.substr(i, 3) == three) return i + 3;
        } else if (text[i] == quote) {
            return i + 1;
        } else if (text[i] == '\n') {
            return i;
        }
    }
    return text.size();
}

size_t end_of_line(std::string_view text, size_t i) {
    const size_t end = text.find('\n', i);
    return end == std::string_view::npos ? text.size() : end;
}

// Lists and tables that are open, and dots since a key began.
struct Depth {
    int open = 0;
    int dots = 0;

    // Takes a character outside strings and comments.
    void take(char c) {
        if (c == '.') {
            ++dots;
        } else if (c == '[' || c == '{') {
            ++open;
            dots = 0;
        } else if (c == ']' || c == '}') {
            if (open > 0) --open;
            dots = 0;
        } else if (c == ',' || c == '=' || c == '\n') {
            dots = 0;
        }
    }
    bool too_deep() const { return open > deepest || dots >= most_parts; }
};

}  // namespace

std::optional<size_t> first_too_deep(std::string_view text) {
    Depth depth;
    for (size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (c == '"' || c == '\'') {
            i = behind_string(text, i);
        } else if (c == '#') {
            i = end_of_line(text, i);
        } else {
            depth.take(c);
            if (depth.too_deep()) return i;
            ++i;
        }
    }
    return std::nullopt;
}

}  // namespace splitsum
