#include "splitsum/color/display.h"

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <utility>

#include "splitsum/base/text.h"
#include "splitsum/color/builtin_config_detail.h"

namespace splitsum {
namespace {

namespace ocio = OCIO_NAMESPACE;

ocio::TransformRcPtr builtin(const char* style) {
    const auto transform = ocio::BuiltinTransform::Create();
    transform->setStyle(style);
    return transform;
}

}  // namespace

struct DisplayTransform::State {
    ocio::ConstCPUProcessorRcPtr processor;
};

DisplayTransform::DisplayTransform(std::unique_ptr<State> state) : state_(std::move(state)) {}
DisplayTransform::~DisplayTransform() = default;
DisplayTransform::DisplayTransform(DisplayTransform&&) noexcept = default;
DisplayTransform& DisplayTransform::operator=(DisplayTransform&&) noexcept = default;

Result<DisplayTransform> DisplayTransform::sdr() {
    try {
        const auto steps = ocio::GroupTransform::Create();
        steps->appendTransform(
            matrix_transform(rgb_from_rgb(aces_ap0_primaries, rec709_primaries)));
        steps->appendTransform(builtin("ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-VIDEO_1.0"));
        steps->appendTransform(builtin("DISPLAY - CIE-XYZ-D65_to_sRGB"));
        auto state = std::make_unique<State>();
        state->processor = ocio::Config::CreateRaw()->getProcessor(steps)->getDefaultCPUProcessor();
        return DisplayTransform(std::move(state));
    } catch (const std::exception& thrown) {
        return Error{ErrorKind::internal,
                     cat("OpenColorIO cannot make the display transform: ", thrown.what())};
    }
}

void DisplayTransform::apply(std::span<float> rgb) const {
    if (rgb.empty()) return;
    ocio::PackedImageDesc pixels(rgb.data(), static_cast<long>(rgb.size() / 3), 1, 3);
    state_->processor->apply(pixels);
    for (float& value : rgb) value = std::clamp(value, 0.0f, 1.0f);
}

}  // namespace splitsum
