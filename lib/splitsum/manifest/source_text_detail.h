#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace splitsum {

/// Something that is wrong with a text, and its line, from 1; 0 if it is wrong as a whole.
struct TextProblem {
    int line = 0;
    std::string text;
};

/// A file's text, or why there is none.
struct SourceText {
    std::string text;
    std::optional<TextProblem> problem;
};

/// Reads a manifest without its byte order mark. A problem: absent, not a file, over 16 MiB, not
/// UTF-8, with control characters, or nested too deeply for parsers that call themselves.
SourceText read_source(const std::filesystem::path& path);

/// Where `text` stops to be UTF-8 or holds a control character other than tab and line ends, if it
/// does so anywhere.
std::optional<size_t> first_bad_byte(std::string_view text);

/// The line, from 1, that a byte is in.
int line_of(std::string_view text, size_t offset);

}  // namespace splitsum
