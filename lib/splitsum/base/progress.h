#pragma once

#include <string_view>

namespace splitsum {

/// Progress and cancellation, handed down as one argument. The library calls it; what happens on
/// the terminal is the caller's business. All functions may be called from any thread.
class Progress {
public:
    virtual ~Progress() = default;

    /// A stage begins that will take `steps` equal steps.
    virtual void begin(std::string_view stage, int steps) = 0;

    /// `steps` more steps of the current stage are done.
    virtual void advance(int steps) = 0;

    /// True when the caller wants the work to stop; the work then ends with an `interrupted` error.
    virtual bool cancelled() const = 0;
};

/// Reports nothing and never cancels.
class NoProgress final : public Progress {
public:
    void begin(std::string_view, int) override {}
    void advance(int) override {}
    bool cancelled() const override { return false; }
};

}  // namespace splitsum
