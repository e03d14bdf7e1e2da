#include "splitsum/manifest/source_text_detail.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "splitsum/base/text.h"
#include "splitsum/manifest/nesting_detail.h"

namespace splitsum {
namespace {

constexpr size_t most_bytes = size_t{16} << 20;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

unsigned char byte_at(std::string_view text, size_t i) {
    return static_cast<unsigned char>(text[i]);
}

// The bytes of the character that begins at `i`, 0 if none does (Unicode 15, table 3-7).
size_t length_of_character(std::string_view text, size_t i) {
    const unsigned char first = byte_at(text, i);
    if (first < 0x80) return 1;
    const size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || i + length > text.size()) return 0;
    // The second byte excludes overlong forms, surrogates and what is beyond U+10FFFF.
    const unsigned char lowest = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
    const unsigned char highest = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
    if (byte_at(text, i + 1) < lowest || byte_at(text, i + 1) > highest) return 0;
    for (size_t k = 2; k < length; ++k)
        if ((byte_at(text, i + k) & 0xC0) != 0x80) return 0;
    return length;
}

bool is_forbidden_control(unsigned char byte) {
    return (byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7F;
}

std::string system_message(int code) { return std::strerror(code); }

std::optional<TextProblem> read_bytes(const std::filesystem::path& path, std::string& bytes) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        return TextProblem{0, "is a folder; a manifest is a file that ends in .toml or .json"};
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) return TextProblem{0, "cannot be read: " + system_message(errno)};
    // Counted while reading: sizes of pipes and devices say nothing.
    std::vector<char> block(size_t{64} << 10);
    while (file.read(block.data(), static_cast<std::streamsize>(block.size())), file.gcount() > 0) {
        bytes.append(block.data(), static_cast<size_t>(file.gcount()));
        if (bytes.size() > most_bytes)
            return TextProblem{
                0, "is larger than 16 MiB; split it and let a short one include the parts"};
    }
    if (file.bad()) return TextProblem{0, "cannot be read: " + system_message(errno)};
    return std::nullopt;
}

std::optional<TextProblem> check_bytes(std::string_view bytes) {
    const auto bad = first_bad_byte(bytes);
    if (!bad) return std::nullopt;
    const bool control = byte_at(bytes, *bad) < 0x80;
    return TextProblem{line_of(bytes, *bad),
                       cat("byte ", *bad, " is ", control ? "a control character" : "not UTF-8",
                           "; save the file as UTF-8 text")};
}

}  // namespace

SourceText read_source(const std::filesystem::path& path) {
    SourceText source;
    if ((source.problem = read_bytes(path, source.text))) return source;
    if (source.text.starts_with(byte_order_mark)) source.text.erase(0, byte_order_mark.size());
    if ((source.problem = check_bytes(source.text))) return source;
    if (const auto deep = first_too_deep(source.text))
        source.problem = TextProblem{line_of(source.text, *deep),
                                     "is nested deeper than any manifest needs to be"};
    return source;
}

std::optional<size_t> first_bad_byte(std::string_view text) {
    for (size_t i = 0; i < text.size();) {
        if (is_forbidden_control(byte_at(text, i))) return i;
        const size_t length = length_of_character(text, i);
        if (length == 0) return i;
        i += length;
    }
    return std::nullopt;
}

int line_of(std::string_view text, size_t offset) {
    const std::string_view before = text.substr(0, offset);
    return 1 + static_cast<int>(std::ranges::count(before, '\n'));
}

}  // namespace splitsum
