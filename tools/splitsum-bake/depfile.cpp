#include "depfile.h"

#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

Status check_names(std::span<const std::string> names) {
    for (const std::string& name : names)
        if (name.find_first_of("\r\n") != std::string::npos)
            return Error{ErrorKind::bad_argument,
                         cat("'", name, "' has a line end in its name, which no depfile can hold")};
    return ok;
}

}  // namespace

std::string escaped_for_make(const std::string& name) {
    std::string escaped;
    size_t backslashes = 0;  // right before this letter
    for (const char letter : name) {
        // Backslashes are letters of the name, but in front of what one of them would escape.
        if (letter == ' ' || letter == '\t' || letter == '#')
            escaped.append(letter == '#' ? 1 : backslashes + 1, '\\');
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
