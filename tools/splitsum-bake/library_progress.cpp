#include "library_progress.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>

#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

using namespace std::chrono_literals;

// Beside its pixels, every panorama costs about as much as reading so many.
constexpr double pixels_of_a_bake = 4e6;

}  // namespace

LibraryProgress::LibraryProgress(ProgressStyle style, std::span<const LibraryJob> jobs,
                                 const Progress& caller)
    : style_(style), jobs_(jobs), caller_(caller) {}

LibraryProgress::~LibraryProgress() { close(); }

void LibraryProgress::print(const std::string& text) {
    const std::lock_guard lock(mutex_);
    if (isatty(STDOUT_FILENO)) wipe();
    std::cout << text << std::flush;
}

void LibraryProgress::close() {
    if (shower_.joinable()) {
        shower_.request_stop();
        shower_.join();
    }
    const std::lock_guard lock(mutex_);
    wipe();
}

void LibraryProgress::begin(std::string_view stage, int steps) {
    const std::lock_guard lock(mutex_);
    stage_ = stage;
    steps_ = std::max(steps, 1);
    steps_done_ = 0;
    if (style_ == ProgressStyle::lines) show_on_terminal(cat(stage, "\n"));
}

void LibraryProgress::advance(int steps) {
    const std::lock_guard lock(mutex_);
    steps_done_ = std::min(steps_done_ + steps, steps_);
}

void LibraryProgress::begun(std::span<const size_t> jobs) {
    const std::lock_guard lock(mutex_);
    asked_ = jobs.size();
    if (style_ == ProgressStyle::none) return;
    if (style_ == ProgressStyle::lines && asked_ > 1)
        show_on_terminal(cat("looking at ", asked_, " panoramas\n"));
    shower_ = std::jthread([this](const std::stop_token& stop) { keep_showing(stop); });
}

void LibraryProgress::planned(std::span<const size_t> jobs, std::span<const int64_t> pixels) {
    const std::lock_guard lock(mutex_);
    for (size_t i = 0; i < jobs.size(); ++i) {
        work_[jobs[i]] = double(pixels[i]) + pixels_of_a_bake;
        work_all_ += work_[jobs[i]];
    }
    since_planned_ = Stopwatch();
    if (style_ == ProgressStyle::lines && asked_ > 1)
        show_on_terminal(cat(jobs.size(), " of ", asked_, " panoramas have to be baked\n"));
}

void LibraryProgress::started(size_t job) {
    const std::lock_guard lock(mutex_);
    running_.emplace(since_planned_.seconds(), job);
}

void LibraryProgress::finished(const LibraryItem& item) {
    const std::lock_guard lock(mutex_);
    std::erase_if(running_, [&](const auto& running) { return running.second == item.job; });
    if (item.outcome == Outcome::not_begun) return;
    ++settled_;
    const auto work = work_.find(item.job);
    if (work == work_.end()) return;
    ++baked_;
    work_done_ += work->second;
}

LibraryState LibraryProgress::state() const {
    LibraryState state;
    state.settled = settled_;
    state.of = asked_;
    // Before it is known what has to be baked, looking is the work.
    state.part = work_all_ > 0 ? work_done_ / work_all_
                               : double(settled_) / double(std::max<size_t>(asked_, 1));
    const double seconds = since_planned_.seconds();
    if (baked_ > 0 && seconds > 0) {
        state.panoramas_a_minute = 60 * double(baked_) / seconds;
        state.seconds_left = seconds * (work_all_ - work_done_) / work_done_;
    }
    for (const auto& [began, job] : running_) state.at.push_back(jobs_[job].panorama.name);
    return state;
}

void LibraryProgress::keep_showing(const std::stop_token& stop) {
    const bool bar = style_ == ProgressStyle::bar;
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        if (bar) draw();
        changed_.wait_for(lock, stop, bar ? 100ms : 10s, [] { return false; });
        if (!bar && asked_ > 1 && !stop.stop_requested())
            show_on_terminal(cat(library_line(state()), "\n"));
    }
}

// Only what changed, and in one piece: nothing flickers.
void LibraryProgress::draw() {
    const int width = terminal_width();
    const std::string line =
        asked_ == 1 ? stage_.empty() ? "" : progress_bar(stage_, 100 * steps_done_ / steps_, width)
                    : library_bar(state(), width);
    if (line == drawn_) return;
    show_on_terminal(cat("\r", line, "\x1b[K"));
    drawn_ = line;
}

void LibraryProgress::wipe() {
    if (!drawn_.empty()) show_on_terminal("\r\x1b[K");
    drawn_.clear();
}

}  // namespace splitsum::tools
