#include "splitsum/preview/view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/temporary_folder.h"

namespace splitsum {
namespace {

// Shows the red channel alone, so that nothing else can be meant.
constexpr const char* config_text = R"(ocio_profile_version: 2
roles:
  default: aces
  scene_linear: aces
  aces_interchange: aces
displays:
  Lamp:
    - !<View> {name: Red, colorspace: red}
  Sun:
    - !<View> {name: Plain, colorspace: aces}
colorspaces:
  - !<ColorSpace>
    name: aces
  - !<ColorSpace>
    name: red
    from_scene_reference: !<MatrixTransform> {matrix: [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1]}
)";

std::vector<float> seen(const View& view, std::vector<float> rgb) {
    view.apply(rgb);
    return rgb;
}

View named(const std::string& name, const std::filesystem::path& config = {}) {
    auto view = View::find(name, config);
    EXPECT_TRUE(view) << view.error().message;
    return std::move(*view);
}

TEST(View, EveryBuiltinOneRisesWithLightAndStaysInRange) {
    for (const ViewInfo& info : views()) {
        const View view = named(std::string(info.name));
        float before = -1;
        for (float light = 0.004f; light < 0.9f; light *= 1.5f) {
            const float shown = seen(view, {light, light, light})[1];
            EXPECT_GT(shown, before) << info.name << " " << light;
            before = shown;
        }
        for (const float shown : seen(view, {-1, 0, 1e6f})) {
            EXPECT_GE(shown, 0) << info.name;
            EXPECT_LE(shown, 1) << info.name;
        }
    }
}

// IEC 61966-2-1: mid grey, and both sides of the kink.
TEST(View, SrgbIsTheStandardsCurve) {
    const auto shown = seen(named("srgb"), {0.2140411f, 0.0031308f, 0.001f, 2, -1, 1});
    EXPECT_NEAR(shown[0], 0.5, 1e-6);
    EXPECT_NEAR(shown[1], 0.04045, 1e-5);
    EXPECT_NEAR(shown[2], 0.01292, 1e-6);
    EXPECT_EQ(shown[3], 1);
    EXPECT_EQ(shown[4], 0);
    EXPECT_EQ(shown[5], 1);
}

// 2.54 / 3.16 of linear 1, encoded.
TEST(View, FilmicCompressesHighlights) {
    const auto shown = seen(named("filmic"), {1, 4, 0});
    EXPECT_NEAR(shown[0], 1.055 * std::pow(2.54 / 3.16, 1 / 2.4) - 0.055, 1e-6);
    EXPECT_GT(shown[1], shown[0]);
    EXPECT_EQ(shown[2], 0);
}

TEST(View, ComesFromAConfig) {
    const tests::TemporaryFolder folder;
    tests::write_bytes(folder / "config.ocio", config_text);
    const auto shown = seen(named("Lamp/Red", folder / "config.ocio"), {0.5f, 0.5f, 0.5f});
    EXPECT_NEAR(shown[0], 0.5, 1e-5);  // a grey is one in ACES too
    EXPECT_EQ(shown[1], 0);
    EXPECT_EQ(shown[2], 0);
}

TEST(View, UnknownOnesAreRefusedWithWhatThereIs) {
    const tests::TemporaryFolder folder;
    tests::write_bytes(folder / "config.ocio", config_text);
    struct Case {
        const char* name;
        std::filesystem::path config;
        const char* says;
    };
    for (const Case& c : {Case{"acse", {}, "did you mean aces?"}, Case{"acse", {}, "--ocio-config"},
                          Case{"Lamp/Red", {}, "aces, filmic, srgb"},
                          Case{"Lamp/Rad", folder / "config.ocio", "Lamp/Red, Sun/Plain"},
                          Case{"Rec", folder / "config.ocio", "Lamp/Red, Sun/Plain"}}) {
        const auto view = View::find(c.name, c.config);
        ASSERT_FALSE(view) << c.name;
        EXPECT_EQ(view.error().kind, ErrorKind::bad_argument);
        EXPECT_NE(view.error().message.find(c.says), std::string::npos) << view.error().message;
    }
    const auto absent = View::find("Lamp/Red", folder / "absent.ocio");
    ASSERT_FALSE(absent);
    EXPECT_EQ(absent.error().kind, ErrorKind::unreadable_input);
}

Image gradient() {
    Image picture(13, 5);
    for (size_t i = 0; i < picture.rgb.size(); ++i) picture.rgb[i] = 0.003f * float(i);
    return picture;
}

TEST(Shown, RoundsEveryPixelOfEveryRow) {
    const Image picture = gradient();
    const View view = named("srgb");
    const auto bytes = shown(picture, view, 0);
    ASSERT_EQ(bytes.size(), picture.rgb.size());
    const auto meant = seen(view, picture.rgb);
    for (size_t i = 0; i < bytes.size(); ++i) EXPECT_EQ(bytes[i], std::lround(255 * meant[i]));
}

TEST(Shown, ExposureIsInStops) {
    Image brighter = gradient();
    for (float& value : brighter.rgb) value *= 4;
    for (const ViewInfo& info : views()) {
        const View view = named(std::string(info.name));
        EXPECT_EQ(shown(gradient(), view, 2), shown(brighter, view, 0)) << info.name;
        EXPECT_NE(shown(gradient(), view, 2), shown(gradient(), view, 0)) << info.name;
    }
}

}  // namespace
}  // namespace splitsum
