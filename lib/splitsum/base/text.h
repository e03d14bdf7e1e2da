#pragma once

#include <sstream>
#include <string>

namespace splitsum {

/// The parts, printed one after the other: cat("size ", 3) is "size 3".
template <class... Parts>
std::string cat(const Parts&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
}

/// The elements separated by `separator`, each printed through `print(element)`.
template <class Range, class Print>
std::string join(const Range& range, const char* separator, const Print& print) {
    std::ostringstream text;
    const char* before = "";
    for (const auto& element : range) {
        text << before << print(element);
        before = separator;
    }
    return text.str();
}

template <class Range>
std::string join(const Range& range, const char* separator) {
    return join(
        range, separator, [](const auto& element) -> const auto& { return element; });
}

}  // namespace splitsum
