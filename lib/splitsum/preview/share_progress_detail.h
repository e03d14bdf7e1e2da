#pragma once

#include <atomic>

#include "splitsum/base/progress.h"

namespace splitsum {

/// Tells a Progress which share of a stage is done, in a hundred steps; never goes back. Any thread
/// may call.
class ShareProgress {
public:
    ShareProgress(Progress& progress, std::string_view stage) : progress_(progress) {
        progress.begin(stage, steps);
    }

    /// `share` in [0, 1].
    void reach(double share) {
        const int now = int(steps * share);
        int before = done_;
        while (before < now && !done_.compare_exchange_weak(before, now)) {
        }
        if (before < now) progress_.advance(now - before);
    }

private:
    static constexpr int steps = 100;
    Progress& progress_;
    std::atomic<int> done_ = 0;
};

}  // namespace splitsum
