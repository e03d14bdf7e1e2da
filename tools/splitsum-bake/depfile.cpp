#include "depfile.h"

#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

// Make would take these for something else, and Ninja does not know what would stop it.
bool fits(const std::string& name) {
    return name.find_first_of("\r\n\t;=") == std::string::npos &&
           name.find("\\#") == std::string::npos && name.find("\\:") == std::string::npos;
}

Status check_names(std::span<const std::string> names) {
    for (const std::string& name : names)
        if (!fits(name))
            return Error{ErrorKind::bad_argument,
                         cat("no depfile can hold the name '", name,
                             "': it has a line end, a tab, ';', '=', or a backslash before '#' or "
                             "':'; rename it, or do without --depfile")};
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
