#pragma once

#include <string_view>

#include "splitsum/base/progress.h"

namespace splitsum {

/// Progress for work inside a step: its own steps are of no interest, a wish to stop is.
class StopOnly final : public Progress {
public:
    explicit StopOnly(const Progress& outer) : outer_(outer) {}
    void begin(std::string_view, int) override {}
    void advance(int) override {}
    bool cancelled() const override { return outer_.cancelled(); }

private:
    const Progress& outer_;
};

}  // namespace splitsum
