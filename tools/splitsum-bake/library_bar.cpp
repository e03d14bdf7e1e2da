#include "library_bar.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>

#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

constexpr size_t least_bar = 10;
constexpr size_t most_bar = 24;

bool begins_a_letter(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) != 0x80; }

// Letters of UTF-8, which is what most terminals show one column each of.
size_t columns_of(std::string_view text) {
    return static_cast<size_t>(std::ranges::count_if(text, begins_a_letter));
}

// The first letters, at most so many columns of them, without what would move the cursor.
std::string fitted(std::string_view text, size_t columns) {
    std::string fit;
    for (const char byte : text) {
        if (begins_a_letter(byte) && columns-- == 0) break;
        const bool is_control = static_cast<unsigned char>(byte) < 32 || byte == 127;
        fit += is_control ? '?' : byte;
    }
    return fit;
}

std::vector<std::string> figures_of(const LibraryState& state) {
    std::vector<std::string> figures = {
        cat(state.settled, "/", state.of),
        cat(static_cast<int>(std::clamp(state.part, 0.0, 1.0) * 100), " %")};
    if (state.seconds_left) figures.push_back(clock_text(*state.seconds_left) + " left");
    if (state.panoramas_a_minute)
        figures.push_back(cat(std::lround(*state.panoramas_a_minute), "/min"));
    return figures;
}

std::string names_of(const LibraryState& state) {
    if (state.at.empty()) return "";
    return state.at.size() == 1 ? state.at.front()
                                : cat(state.at.front(), " +", state.at.size() - 1);
}

// Appends the text behind two blanks if there is room for it.
void append(std::string& line, const std::string& text, size_t room) {
    const size_t gap = line.empty() ? 0 : 2;
    if (columns_of(line) + gap + columns_of(text) > room || text.empty()) return;
    line.append(gap, ' ').append(text);
}

}  // namespace

std::string library_bar(const LibraryState& state, int width) {
    // The last column stays free: writing it makes some terminals wrap.
    const size_t room = static_cast<size_t>(std::max(width - 1, 0));
    std::string line;
    for (const std::string& figure : figures_of(state)) append(line, figure, room);
    const size_t left = room - columns_of(line);
    const size_t length = left < least_bar + 4 ? 0 : std::min(most_bar, left - 4);
    if (length > 0) {
        const auto filled = static_cast<size_t>(std::clamp(state.part, 0.0, 1.0) * double(length));
        append(line, cat("[", std::string(filled, '#'), std::string(length - filled, '.'), "]"),
               room);
    }
    const size_t used = columns_of(line) + 2;
    if (used < room) append(line, fitted(names_of(state), room - used), room);
    return line;
}

std::string library_line(const LibraryState& state) {
    std::string line = join(figures_of(state), ", ");
    const std::string names = names_of(state);
    return names.empty() ? line : cat(line, ", at ", fitted(names, SIZE_MAX));
}

std::string clock_text(double seconds) {
    const auto whole = static_cast<int64_t>(std::clamp(std::ceil(seconds), 0.0, 1e9));
    const auto two = [](int64_t number) { return cat(number < 10 ? "0" : "", number); };
    const int64_t minutes = whole / 60 % 60;
    if (whole < 3600) return cat(minutes, ":", two(whole % 60));
    return cat(whole / 3600, ":", two(minutes), ":", two(whole % 60));
}

}  // namespace splitsum::tools
