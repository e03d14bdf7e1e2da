#include "splitsum/manifest/problems_detail.h"

#include <algorithm>
#include <tuple>

#include "splitsum/base/text.h"

namespace splitsum {

void Problems::add(const std::filesystem::path& file, int line, const std::string& text) {
    add(file, line, text, ErrorKind::bad_argument);
}

void Problems::add_unreadable(const std::filesystem::path& file, int line,
                              const std::string& text) {
    add(file, line, text, ErrorKind::unreadable_input);
}

void Problems::add(const std::filesystem::path& file, int line, const std::string& text,
                   ErrorKind kind) {
    if (kind == ErrorKind::unreadable_input) kind_ = kind;
    auto known = std::ranges::find(files_, file);
    if (known == files_.end()) known = files_.insert(files_.end(), file);
    problems_.push_back({static_cast<size_t>(known - files_.begin()), line, text});
}

Error Problems::error() const {
    std::vector<Problem> sorted = problems_;
    std::ranges::stable_sort(sorted, {},
                             [](const Problem& p) { return std::tuple(p.file, p.line); });
    const size_t listed = std::min(sorted.size(), most_listed);
    const size_t more = sorted.size() - listed;
    sorted.resize(listed);
    std::string message = join(sorted, "\n", [&](const Problem& problem) {
        return place_prefix(files_[problem.file], problem.line) + problem.text;
    });
    if (more > 0) message += cat("\nand ", more, " more ", more == 1 ? "problem" : "problems");
    return {kind_, message};
}

std::string place_prefix(const std::filesystem::path& file, int line) {
    return line > 0 ? cat(file.string(), ":", line, ": ") : file.string() + ": ";
}

std::string in_quotes(std::string_view text) {
    constexpr size_t longest = 80;
    std::string shown(text.substr(0, longest));
    // Not in the middle of a character of several bytes.
    if (shown.size() < text.size())
        while (!shown.empty() && (static_cast<unsigned char>(text[shown.size()]) & 0xC0) == 0x80)
            shown.pop_back();
    for (char& letter : shown)
        if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F) letter = '?';
    return cat("'", shown, shown.size() < text.size() ? "...'" : "'");
}

}  // namespace splitsum
