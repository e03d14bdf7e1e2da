#include "splitsum/color/color_space.h"

#include <OpenColorIO/OpenColorIO.h>

#include <cmath>
#include <cstring>
#include <utility>

#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/color/builtin_config_detail.h"

namespace splitsum {
namespace {

namespace ocio = OCIO_NAMESPACE;
namespace fs = std::filesystem;

// Lossless: OpenColorIO's default replaces powers by approximations of 1e-4.
ocio::ConstCPUProcessorRcPtr on_cpu(const ocio::ConstProcessorRcPtr& processor) {
    return processor->isNoOp() ? nullptr
                               : processor->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS);
}

const char* space_of_role(const ocio::ConstConfigRcPtr& config, const char* role) {
    const auto space = config->getColorSpace(role);
    return space ? space->getName() : nullptr;
}

}  // namespace

struct ColorConverter::State {
    ocio::ConstCPUProcessorRcPtr processor;  ///< null where nothing changes
};

ColorConverter::ColorConverter() : state_(std::make_unique<State>()) {}
ColorConverter::~ColorConverter() = default;
ColorConverter::ColorConverter(ColorConverter&&) noexcept = default;
ColorConverter& ColorConverter::operator=(ColorConverter&&) noexcept = default;

bool ColorConverter::changes_nothing() const { return !state_->processor; }

void ColorConverter::apply(Image& image) const {
    if (changes_nothing()) return;
    parallel_rows(image.height, [&](int y) { apply(image.row(y)); });
}

void ColorConverter::apply(std::span<float> rgb) const {
    if (changes_nothing()) return;
    ocio::PackedImageDesc row(rgb.data(), static_cast<long>(rgb.size() / 3), 1, 3);
    state_->processor->apply(row);
}

struct ColorConfig::State {
    ocio::ConstConfigRcPtr config;
    ocio::ConstConfigRcPtr builtin;  ///< null where `config` is the built-in one
    fs::path file;
    std::string default_space;
    bool joined_through_aces = false;  ///< `config` and `builtin` share aces_interchange
    std::string note;

    std::string name() const {
        return builtin ? cat("the config ", file.string()) : std::string("the built-in config");
    }
    Status find_working_space();
    ocio::ConstProcessorRcPtr processor_from(const std::string& space) const;
};

Status ColorConfig::State::find_working_space() {
    const char* scene_linear = space_of_role(config, ocio::ROLE_SCENE_LINEAR);
    const char* interchange = space_of_role(config, ocio::ROLE_INTERCHANGE_SCENE);
    if (!scene_linear && !interchange)
        return Error{ErrorKind::bad_argument,
                     cat(name(),
                         " has neither the role scene_linear nor aces_interchange; one of "
                         "them must say what linear light is")};
    default_space = scene_linear ? scene_linear : interchange;
    joined_through_aces = builtin && interchange;
    if (builtin && !interchange)
        note = cat("the OpenColorIO config has no role aces_interchange: its scene_linear space '",
                   default_space, "' was taken for linear Rec.709");
    return ok;
}

ocio::ConstProcessorRcPtr ColorConfig::State::processor_from(const std::string& space) const {
    if (joined_through_aces)
        return ocio::Config::GetProcessorFromConfigs(config, space.c_str(), builtin, working_space);
    return config->getProcessor(space.c_str(), default_space.c_str());
}

ColorConfig::ColorConfig(std::unique_ptr<State> state) : state_(std::move(state)) {}
ColorConfig::~ColorConfig() = default;
ColorConfig::ColorConfig(ColorConfig&&) noexcept = default;
ColorConfig& ColorConfig::operator=(ColorConfig&&) noexcept = default;

Result<ColorConfig> ColorConfig::load(const fs::path& file) {
    const auto config = load_config(file);
    if (!config) return config.error();
    auto state = std::make_unique<State>();
    state->config = *config;
    state->file = file;
    if (!file.empty()) state->builtin = make_builtin_config();
    if (Status found = state->find_working_space(); !found) return found.error();
    return ColorConfig(std::move(state));
}

std::optional<std::string> ColorConfig::find(const std::string& name) const {
    if (name.empty()) return std::nullopt;
    const auto space = state_->config->getColorSpace(name.c_str());
    if (!space) return std::nullopt;
    return std::string(space->getName());
}

std::string ColorConfig::default_space() const { return state_->default_space; }

std::vector<std::string> ColorConfig::spaces() const {
    std::vector<std::string> names;
    for (int i = 0; i < state_->config->getNumColorSpaces(); ++i)
        names.emplace_back(state_->config->getColorSpaceNameByIndex(i));
    return names;
}

const std::string& ColorConfig::note() const { return state_->note; }

Result<ColorConverter> ColorConfig::converter_from(const std::string& name) const {
    const auto space = find(name);
    if (!space)
        return Error{ErrorKind::bad_argument,
                     cat("no colour space '", name, "' in ", state_->name(),
                         "; there are: ", join(spaces(), ", "))};
    if (state_->config->getColorSpace(space->c_str())->isData())
        return Error{ErrorKind::bad_argument,
                     cat("'", *space, "' in ", state_->name(),
                         " holds data, not colours; choose another space")};
    try {
        ColorConverter converter;
        converter.state_->processor = on_cpu(state_->processor_from(*space));
        return converter;
    } catch (const std::exception& thrown) {
        return Error{ErrorKind::bad_argument, cat("cannot convert from colour space '", *space,
                                                  "' of ", state_->name(), ": ", thrown.what())};
    }
}

Result<ColorConverter> ColorConfig::converter_from_primaries(const Primaries& primaries) {
    if (!are_usable(primaries))
        return Error{ErrorKind::bad_argument,
                     cat("the chromaticities ", join(primaries, " "), " span no colours")};
    ColorConverter converter;
    const auto config = ocio::Config::CreateRaw();
    converter.state_->processor =
        on_cpu(config->getProcessor(matrix_transform(rgb_from_rgb(rec709_primaries, primaries))));
    return converter;
}

std::optional<std::string> space_with_primaries(const Primaries& primaries) {
    static constexpr std::pair<const char*, const Primaries*> known[] = {
        {working_space, &rec709_primaries}, {"ACES2065-1", &aces_ap0_primaries},
        {"ACEScg", &aces_ap1_primaries},    {"lin_rec2020", &rec2020_primaries},
        {"lin_p3d65", &p3_d65_primaries},
    };
    for (const auto& [name, values] : known) {
        bool same = true;
        for (size_t i = 0; i < values->size(); ++i)
            same &= std::abs((*values)[i] - primaries[i]) <= 1e-3;
        if (same) return name;
    }
    return std::nullopt;
}

}  // namespace splitsum
