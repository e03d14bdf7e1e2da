#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/image/image.h"

namespace splitsum {

/// A way to show scene-linear Rec.709 that needs no OpenColorIO config.
struct ViewInfo {
    std::string_view name;     ///< as typed after --view
    std::string_view summary;  ///< one line for --help
};

/// Every such view; the first is the default.
std::span<const ViewInfo> views();

/// Whether it is the name of one of them.
bool is_builtin(std::string_view view);

/// How scene-linear Rec.709 becomes what a screen is sent.
class View {
public:
    /// A view of views(), or "display/view" of an OpenColorIO config. Fails with bad_argument for an
    /// unknown name, with what there is, and as DisplayTransform::of_config does.
    static Result<View> find(const std::string& name, const std::filesystem::path& ocio_config);

    /// Linear RGB triples to encoded RGB in [0, 1], in place. May be called from any thread.
    void apply(std::span<float> rgb) const { transform_(rgb); }

private:
    using Transform = std::function<void(std::span<float> rgb)>;
    explicit View(Transform transform) : transform_(std::move(transform)) {}
    Transform transform_;
};

/// The picture as bytes of RGB, row 0 at the top, light multiplied by 2^`exposure_stops` before.
std::vector<uint8_t> shown(const Image& picture, const View& view, double exposure_stops);

}  // namespace splitsum
