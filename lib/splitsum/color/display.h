#pragma once

#include <memory>
#include <span>

#include "splitsum/base/result.h"

namespace splitsum {

/// Linear Rec.709 to what an sRGB screen shows: the ACES 1.0 SDR video output transform (Academy
/// S-2014-008 and its RRT), as OpenColorIO ships it. It compresses highlights without clipping and
/// shows linear 0.18 at 0.36. Anything above about 16 comes out as white.
class DisplayTransform {
public:
    /// Fails with internal where this OpenColorIO lacks the transform.
    static Result<DisplayTransform> sdr();

    ~DisplayTransform();
    DisplayTransform(DisplayTransform&&) noexcept;
    DisplayTransform& operator=(DisplayTransform&&) noexcept;

    /// Linear RGB triples to encoded sRGB in [0, 1], in place. May be called from any thread.
    void apply(std::span<float> rgb) const;

private:
    struct State;
    explicit DisplayTransform(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace splitsum
