#include "depfile.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

// What is left, Make or Ninja would take for something else.
bool fits(const std::string& name) {
    const auto is_readable = [](char letter) {
        const auto byte = static_cast<unsigned char>(letter);
        return byte >= 0x80 || std::isalnum(byte) ||
               std::string_view(" #$:\\+,/_.~(){}%@[]!-").find(letter) != std::string_view::npos;
    };
    return std::ranges::all_of(name, is_readable) && name.find("\\#") == std::string::npos &&
           name.find("\\:") == std::string::npos;
}

Status check_names(std::span<const std::string> names) {
    for (const std::string& name : names)
        if (!fits(name))
            return Error{ErrorKind::bad_argument,
                         cat("no depfile can hold the name '", name,
                             "' so that Make and Ninja both read it; rename it (letters, digits, "
                             "blanks and any of #$:\\+,/_.~(){}%@[]!- work), or do without "
                             "--depfile")};
    return ok;
}

}  // namespace

std::string escaped_for_make(const std::string& name) {
    std::string escaped;
    size_t backslashes = 0;  // right before this letter
    for (const char letter : name) {
        // Backslashes are letters of the name, but in front of a blank that one of them escapes.
        if (letter == ' ') escaped.append(backslashes + 1, '\\');
        if (letter == '#' || letter == ':') escaped += '\\';
        if (letter == '$') escaped += '$';
        escaped += letter;
        backslashes = letter == '\\' ? backslashes + 1 : 0;
    }
    return escaped;
}

Result<std::string> depfile_text(std::span<const std::string> targets,
                                 std::span<const std::string> sources) {
    for (const auto names : {targets, sources})
        if (const Status fit = check_names(names); !fit) return fit.error();
    std::string text = cat(join(targets, " \\\n", escaped_for_make), ":");
    for (const std::string& source : sources) text += cat(" \\\n  ", escaped_for_make(source));
    text += "\n";
    for (const std::string& source : sources) text += cat("\n", escaped_for_make(source), ":\n");
    return text;
}

}  // namespace splitsum::tools
