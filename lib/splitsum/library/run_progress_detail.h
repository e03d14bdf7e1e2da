#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"

namespace splitsum {

/// What the bakes of a run see: cancelled when the caller cancels, or when something stopped the
/// run. Stages go on to the caller only where one panorama is baked.
class RunProgress final : public Progress {
public:
    explicit RunProgress(Progress& caller) : caller_(caller) {}

    void show_stages() { stages_ = true; }

    /// Stops the run; the first reason counts.
    void stop(Error reason) {
        const std::lock_guard lock(mutex_);
        if (!reason_) reason_ = std::move(reason);
        stopped_ = true;
    }

    /// Why the run was stopped, other than by the caller.
    std::optional<Error> reason() const {
        const std::lock_guard lock(mutex_);
        return reason_;
    }

    void begin(std::string_view stage, int steps) override {
        if (stages_) caller_.begin(stage, steps);
    }
    void advance(int steps) override {
        if (stages_) caller_.advance(steps);
    }
    bool cancelled() const override { return stopped_ || caller_.cancelled(); }

private:
    Progress& caller_;
    bool stages_ = false;
    std::atomic<bool> stopped_ = false;
    mutable std::mutex mutex_;
    std::optional<Error> reason_;
};

}  // namespace splitsum
