#include "splitsum/color/display.h"

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <utility>

#include "splitsum/base/edit_distance.h"
#include "splitsum/base/text.h"
#include "splitsum/color/builtin_config_detail.h"

namespace splitsum {
namespace {

namespace ocio = OCIO_NAMESPACE;
namespace fs = std::filesystem;

struct DisplayView {
    std::string display;
    std::string view;

    std::string name() const { return cat(display, "/", view); }
};

ocio::TransformRcPtr builtin(const char* style) {
    const auto transform = ocio::BuiltinTransform::Create();
    transform->setStyle(style);
    return transform;
}

ocio::TransformRcPtr aces_from_working_space() {
    return matrix_transform(rgb_from_rgb(aces_ap0_primaries, rec709_primaries));
}

std::vector<DisplayView> views_of(const ocio::Config& config) {
    std::vector<DisplayView> views;
    for (int d = 0; d < config.getNumDisplays(); ++d) {
        const char* display = config.getDisplay(d);
        for (int v = 0; v < config.getNumViews(display); ++v)
            views.push_back({display, config.getView(display, v)});
    }
    return views;
}

Error no_view(const std::string& name, const fs::path& file,
              const std::vector<DisplayView>& views) {
    std::vector<std::string> names;
    for (const DisplayView& view : views) names.push_back(view.name());
    return {ErrorKind::bad_argument, cat("no view '", name, "' in ", file.string(),
                                         names_instead(name, names), names.empty() ? "none" : "")};
}

// From the working space through the role that joins it to the config.
ocio::GroupTransformRcPtr shown_by(const ocio::Config& config, const DisplayView& wanted) {
    const bool has_aces = config.hasRole(ocio::ROLE_INTERCHANGE_SCENE);
    if (!has_aces && !config.hasRole(ocio::ROLE_SCENE_LINEAR)) return nullptr;
    const auto steps = ocio::GroupTransform::Create();
    if (has_aces) steps->appendTransform(aces_from_working_space());
    const auto view = ocio::DisplayViewTransform::Create();
    view->setSrc(has_aces ? ocio::ROLE_INTERCHANGE_SCENE : ocio::ROLE_SCENE_LINEAR);
    view->setDisplay(wanted.display.c_str());
    view->setView(wanted.view.c_str());
    steps->appendTransform(view);
    return steps;
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
        steps->appendTransform(aces_from_working_space());
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

Result<DisplayTransform> DisplayTransform::of_config(const fs::path& file,
                                                     const std::string& display_and_view) {
    const auto config = load_config(file);
    if (!config) return config.error();
    const std::vector<DisplayView> views = views_of(**config);
    const auto view = std::ranges::find(views, display_and_view, &DisplayView::name);
    if (view == views.end()) return no_view(display_and_view, file, views);
    try {
        const auto steps = shown_by(**config, *view);
        if (!steps)
            return Error{ErrorKind::bad_argument,
                         cat(file.string(),
                             " has neither the role scene_linear nor "
                             "aces_interchange; one of them must say what linear "
                             "light is")};
        auto state = std::make_unique<State>();
        state->processor = (*config)->getProcessor(steps)->getDefaultCPUProcessor();
        return DisplayTransform(std::move(state));
    } catch (const std::exception& thrown) {
        return Error{ErrorKind::bad_argument, cat("the view '", display_and_view, "' of ",
                                                  file.string(), " fails: ", thrown.what())};
    }
}

void DisplayTransform::apply(std::span<float> rgb) const {
    if (rgb.empty()) return;
    ocio::PackedImageDesc pixels(rgb.data(), static_cast<long>(rgb.size() / 3), 1, 3);
    state_->processor->apply(pixels);
    for (float& value : rgb) value = std::clamp(value, 0.0f, 1.0f);
}

Result<std::vector<std::string>> views_of_config(const fs::path& file) {
    const auto config = load_config(file);
    if (!config) return config.error();
    std::vector<std::string> names;
    for (const DisplayView& view : views_of(**config)) names.push_back(view.name());
    return names;
}

}  // namespace splitsum
