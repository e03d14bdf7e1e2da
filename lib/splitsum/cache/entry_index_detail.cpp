#include "splitsum/cache/entry_index_detail.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <sstream>

#include "splitsum/base/content_hash.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

constexpr std::string_view title = "splitsum cache entry 1";

std::string hash_of(std::string_view text) {
    ContentHash hash;
    hash.add(text);
    return hash.digits();
}

// "HASH BYTES NAME"
std::optional<IndexedFile> parse_file(std::string_view line) {
    if (line.size() < 33 || line[32] != ' ' || !is_digits(line.substr(0, 32))) return std::nullopt;
    IndexedFile file{{}, {0, std::string(line.substr(0, 32))}};
    line.remove_prefix(33);
    const auto [end, failure] =
        std::from_chars(line.data(), line.data() + line.size(), file.sum.bytes);
    if (failure != std::errc{} || file.sum.bytes < 0) return std::nullopt;
    line.remove_prefix(static_cast<size_t>(end - line.data()));
    if (line.empty() || line[0] != ' ') return std::nullopt;
    file.name = line.substr(1);
    return is_file_name(file.name) ? std::optional(std::move(file)) : std::nullopt;
}

}  // namespace

bool is_digits(std::string_view text) {
    return text.size() == 32 && text.find_first_not_of("0123456789abcdef") == text.npos;
}

bool is_file_name(std::string_view name) {
    const auto is_refused = [](unsigned char letter) { return letter < ' ' || letter == '/'; };
    return !name.empty() && name.size() < 256 && name[0] != '.' &&
           std::ranges::none_of(name, is_refused);
}

int64_t EntryIndex::bytes() const {
    int64_t sum = 0;
    for (const IndexedFile& file : files) {
        if (file.sum.bytes > std::numeric_limits<int64_t>::max() - sum)
            return std::numeric_limits<int64_t>::max();
        sum += file.sum.bytes;
    }
    return sum;
}

std::string text_of(const EntryIndex& index) {
    std::string text = cat(title, '\n', "key ", index.key, '\n');
    for (const IndexedFile& file : index.files)
        text += cat(file.sum.hash, ' ', file.sum.bytes, ' ', file.name, '\n');
    return cat(text, "index ", hash_of(text), '\n');
}

std::optional<EntryIndex> parse_index(const std::string& text) {
    std::istringstream stream(text);
    std::string line;
    if (!std::getline(stream, line) || line != title) return std::nullopt;
    if (!std::getline(stream, line) || !line.starts_with("key ")) return std::nullopt;
    EntryIndex index{line.substr(4), {}};
    while (std::getline(stream, line) && !line.starts_with("index ")) {
        auto file = parse_file(line);
        if (!file) return std::nullopt;
        index.files.push_back(std::move(*file));
    }
    // Covers the hash in the last line too, and that nothing follows it.
    return is_digits(index.key) && text_of(index) == text ? std::optional(std::move(index))
                                                          : std::nullopt;
}

}  // namespace splitsum
