#include "splitsum/color/builtin_config_detail.h"

#include <array>
#include <initializer_list>

#include "splitsum/base/text.h"
#include "splitsum/color/color_space.h"

namespace splitsum {
namespace {

namespace ocio = OCIO_NAMESPACE;

void add_space(ocio::Config& config, const char* name, std::initializer_list<const char*> aliases,
               const char* description, const ocio::ConstTransformRcPtr& to_reference) {
    const auto space = ocio::ColorSpace::Create();
    space->setName(name);
    for (const char* alias : aliases) space->addAlias(alias);
    space->setDescription(description);
    space->setBitDepth(ocio::BIT_DEPTH_F32);
    if (to_reference) space->setTransform(to_reference, ocio::COLORSPACE_DIR_TO_REFERENCE);
    config.addColorSpace(space);
}

void add_linear_space(ocio::Config& config, const char* name,
                      std::initializer_list<const char*> aliases, const char* description,
                      const Primaries& primaries) {
    add_space(config, name, aliases, description,
              matrix_transform(rgb_from_rgb(rec709_primaries, primaries)));
}

// A linear toe below a power law: x = ((y + offset) / (1 + offset))^gamma.
ocio::ConstTransformRcPtr curve_with_toe(double gamma, double offset) {
    const auto curve = ocio::ExponentWithLinearTransform::Create();
    curve->setGamma({gamma, gamma, gamma, 1});
    curve->setOffset({offset, offset, offset, 0});
    curve->setNegativeStyle(ocio::NEGATIVE_LINEAR);
    return curve;
}

ocio::ConstTransformRcPtr power_law(double gamma) {
    const auto curve = ocio::ExponentTransform::Create();
    curve->setValue({gamma, gamma, gamma, 1});
    curve->setNegativeStyle(ocio::NEGATIVE_MIRROR);
    return curve;
}

void add_linear_spaces(ocio::Config& config) {
    add_space(config, working_space,
              {"Linear", "lin_srgb", "rec709_linear", "Linear Rec.709", "Linear Rec.709 (sRGB)",
               "Utility - Linear - Rec.709", "Utility - Linear - sRGB"},
              "Linear light, Rec.709 primaries, D65: the working space", nullptr);
    add_linear_space(config, "ACES2065-1", {"aces", "lin_ap0", "ACES - ACES2065-1"},
                     "Linear light, ACES AP0 primaries (SMPTE ST 2065-1)", aces_ap0_primaries);
    add_linear_space(config, "ACEScg", {"lin_ap1", "ACES - ACEScg"},
                     "Linear light, ACES AP1 primaries (S-2014-004)", aces_ap1_primaries);
    add_linear_space(config, "lin_rec2020", {"Linear Rec.2020", "Utility - Linear - Rec.2020"},
                     "Linear light, Rec.2020 primaries, D65", rec2020_primaries);
    add_linear_space(
        config, "lin_p3d65",
        {"Linear P3-D65", "lin_displayp3", "Linear Display P3", "Utility - Linear - P3-D65"},
        "Linear light, P3 primaries, D65", p3_d65_primaries);
    add_space(config, "XYZ-D65", {"CIE-XYZ-D65", "CIE XYZ-D65", "CIE-XYZ D65"},
              "CIE 1931 XYZ relative to a D65 white", matrix_transform(rec709_from_xyz_d65()));
}

void add_encoded_spaces(ocio::Config& config) {
    add_space(config, "sRGB",
              {"srgb_texture", "srgb_tx", "sRGB - Texture", "Utility - sRGB - Texture"},
              "sRGB (IEC 61966-2-1)", curve_with_toe(2.4, 0.055));
    add_space(config, "g22_rec709",
              {"Gamma2.2", "GammaCorrected2.2", "Gamma 2.2 Rec.709 - Texture", "g22_rec709_tx"},
              "Power law 2.2, Rec.709 primaries", power_law(2.2));
    // ITU-R BT.709-6, 1.2: E' = 1.099 L^0.45 - 0.099.
    add_space(config, "Rec709", {"Rec.709", "camera_rec709", "Camera Rec.709"},
              "Rec.709 camera curve (ITU-R BT.709-6)", curve_with_toe(1 / 0.45, 0.099));
}

}  // namespace

ocio::MatrixTransformRcPtr matrix_transform(const ColorMatrix& m) {
    const std::array<double, 16> values = {m[0], m[1], m[2], 0, m[3], m[4], m[5], 0,
                                           m[6], m[7], m[8], 0, 0,    0,    0,    1};
    const auto transform = ocio::MatrixTransform::Create();
    transform->setMatrix(values.data());
    return transform;
}

ocio::ConstConfigRcPtr make_builtin_config() {
    const auto config = ocio::Config::Create();
    config->setName("splitsum");
    add_linear_spaces(*config);
    add_encoded_spaces(*config);
    config->setRole(ocio::ROLE_SCENE_LINEAR, working_space);
    config->setRole(ocio::ROLE_INTERCHANGE_SCENE, "ACES2065-1");
    return config;
}

Result<ocio::ConstConfigRcPtr> load_config(const std::filesystem::path& file) {
    try {
        if (file.empty()) return make_builtin_config();
        const auto config = ocio::Config::CreateFromFile(file.c_str());
        config->validate();
        return config;
    } catch (const std::exception& thrown) {
        return Error{ErrorKind::unreadable_input,
                     cat("cannot use the OpenColorIO config ", file.string(), ": ", thrown.what())};
    }
}

}  // namespace splitsum
