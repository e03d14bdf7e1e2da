#include "common/progress_line.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

constexpr const char* wiped_line = "\r\x1b[K";

}  // namespace

ProgressStyle progress_style(bool quiet) {
    if (quiet) return ProgressStyle::none;
    const char* terminal = std::getenv("TERM");
    const bool can_redraw = terminal && std::strcmp(terminal, "dumb") != 0;
    return isatty(STDERR_FILENO) && can_redraw ? ProgressStyle::bar : ProgressStyle::lines;
}

int terminal_width() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

void show_on_terminal(const std::string& text) {
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
}

std::string progress_bar(std::string_view stage, int percent, int width) {
    const std::string number = cat(percent < 10 ? "  " : percent < 100 ? " " : "", percent, " %");
    // The last column stays free: writing it makes some terminals wrap.
    const int room = width - 1 - static_cast<int>(stage.size() + number.size()) - 4;
    if (room < 10)
        return cat(stage, " ", number).substr(0, static_cast<size_t>(std::max(width - 1, 0)));
    const int length = std::min(room, 40);
    const int filled = length * percent / 100;
    return cat(stage, " [", std::string(static_cast<size_t>(filled), '#'),
               std::string(static_cast<size_t>(length - filled), '.'), "] ", number);
}

ProgressLine::~ProgressLine() {
    if (style_ == ProgressStyle::bar && drawn_percent_ >= 0) show_on_terminal(wiped_line);
}

void ProgressLine::begin(std::string_view stage, int steps) {
    const std::lock_guard lock(mutex_);
    stage_ = stage;
    steps_ = std::max(steps, 1);
    done_ = 0;
    drawn_percent_ = -1;
    if (style_ == ProgressStyle::lines) show_on_terminal(cat(stage_, "\n"));
    draw();
}

void ProgressLine::advance(int steps) {
    const std::lock_guard lock(mutex_);
    done_ = std::min(done_ + steps, steps_);
    draw();
}

void ProgressLine::draw() {
    if (style_ != ProgressStyle::bar) return;
    const int percent = static_cast<int>(100LL * done_ / std::max(steps_, 1));
    if (percent == drawn_percent_) return;
    drawn_percent_ = percent;
    show_on_terminal(cat("\r", progress_bar(stage_, percent, terminal_width()), "\x1b[K"));
}

}  // namespace splitsum::tools
