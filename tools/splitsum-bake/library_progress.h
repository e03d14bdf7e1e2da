#pragma once

#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <set>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "common/progress_line.h"
#include "library_bar.h"
#include "splitsum/library/bake_library.h"
#include "splitsum/library/stopwatch.h"

namespace splitsum::tools {

/// Shows on stderr how far a library is: a line that is redrawn at most ten times a second and
/// follows the terminal's width, or a line every ten seconds for logs. Of a single panorama it shows
/// the stages. Safe to call from many threads.
class LibraryProgress final : public Progress, public LibraryObserver {
public:
    /// `caller` says when to stop, and must outlive the object; so must `jobs`.
    LibraryProgress(ProgressStyle style, std::span<const LibraryJob> jobs, const Progress& caller);
    ~LibraryProgress() override;

    /// Prints results on stdout, clear of the bar.
    void print(const std::string& text);

    /// Wipes the bar; nothing is shown from here on.
    void close();

    void begin(std::string_view stage, int steps) override;
    void advance(int steps) override;
    bool cancelled() const override { return caller_.cancelled(); }

    void begun(std::span<const size_t> jobs) override;
    void planned(std::span<const size_t> jobs, std::span<const int64_t> pixels) override;
    void started(size_t job) override;
    void finished(const LibraryItem& item) override;

private:
    void keep_showing(const std::stop_token& stop);
    LibraryState state() const;
    void draw();
    void wipe();

    const ProgressStyle style_;
    const std::span<const LibraryJob> jobs_;
    const Progress& caller_;

    mutable std::mutex mutex_;  // of everything below
    std::condition_variable_any changed_;
    size_t asked_ = 0, settled_ = 0;
    size_t baked_ = 0;               // settled since they were planned
    std::map<size_t, double> work_;  // of each planned job
    double work_done_ = 0, work_all_ = 0;
    Stopwatch since_planned_;
    std::set<std::pair<double, size_t>> running_;  // seconds since_planned_ when they began
    std::string stage_;                            // of a single panorama
    int steps_ = 0, steps_done_ = 0;
    std::string drawn_;
    std::jthread shower_;
};

}  // namespace splitsum::tools
