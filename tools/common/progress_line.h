#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <string_view>

#include "splitsum/base/progress.h"

namespace splitsum::tools {

/// How much of the progress is shown on stderr.
enum class ProgressStyle {
    none,   ///< nothing
    lines,  ///< a line when a stage begins, for logs
    bar,    ///< one line that is redrawn, for a terminal
};

/// `bar` when stderr is a terminal that can redraw a line, `lines` otherwise; `none` with `quiet`.
ProgressStyle progress_style(bool quiet);

/// Shows progress on stderr; nobody else writes there while work goes on. The bar is wiped when the
/// object goes, so that what follows starts on an empty line. Safe to call from many threads.
class ProgressLine final : public Progress {
public:
    /// `cancelled` is read, never written, and must outlive the object.
    ProgressLine(ProgressStyle style, const std::atomic<bool>& cancelled)
        : style_(style), cancelled_(cancelled) {}
    ~ProgressLine() override;
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void begin(std::string_view stage, int steps) override;
    void advance(int steps) override;
    bool cancelled() const override { return cancelled_.load(std::memory_order_relaxed); }

private:
    void draw();

    const ProgressStyle style_;
    const std::atomic<bool>& cancelled_;
    std::mutex mutex_;  // of everything below
    std::string stage_;
    int steps_ = 0;
    int done_ = 0;
    int drawn_percent_ = -1;
};

/// Columns of the terminal on stderr; 80 where it does not say.
int terminal_width();

/// Writes to stderr in one piece, so that lines of several processes do not mix.
void show_on_terminal(const std::string& text);

/// The bar as it is drawn: the stage, a bar and a percentage in at most `width` columns; the bar is
/// left out where it would have fewer than ten.
std::string progress_bar(std::string_view stage, int percent, int width);

}  // namespace splitsum::tools
