#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "splitsum/base/result.h"

namespace splitsum {

/// Linear Rec.709 to what a screen shows.
class DisplayTransform {
public:
    /// The ACES 1.0 SDR video output transform (Academy S-2014-008 and its RRT) for an sRGB screen, as
    /// OpenColorIO ships it. It compresses highlights without clipping and shows linear 0.18 at 0.36.
    /// Anything above about 16 comes out as white. Fails with internal where this OpenColorIO lacks
    /// the transform.
    static Result<DisplayTransform> sdr();

    /// A view of an OpenColorIO config, named "display/view" as views_of_config() lists them, with
    /// the looks that the config gives it. Rec.709 is taken to the config through aces_interchange,
    /// or for its scene_linear where it has no such role. Fails with unreadable_input (absent or no
    /// config) and bad_argument (no such view, neither role; a file that the view needs is missing).
    static Result<DisplayTransform> of_config(const std::filesystem::path& config,
                                              const std::string& display_and_view);

    ~DisplayTransform();
    DisplayTransform(DisplayTransform&&) noexcept;
    DisplayTransform& operator=(DisplayTransform&&) noexcept;

    /// Linear RGB triples to encoded RGB in [0, 1], in place. May be called from any thread.
    void apply(std::span<float> rgb) const;

private:
    struct State;
    explicit DisplayTransform(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Every view of every display of an OpenColorIO config, in its order, as "display/view". Fails with
/// unreadable_input.
Result<std::vector<std::string>> views_of_config(const std::filesystem::path& config);

}  // namespace splitsum
