// Where a light in the panorama ends up in the cube: against the formulas of --help, and through
// splitsum-compare, which reads the orientation from the file.
#include <cmath>
#include <numbers>

#include "support/temporary_folder.h"
#include "tools/programs.h"
#include "tools/textures.h"

namespace splitsum::tests {
namespace {

constexpr double pi = std::numbers::pi;
const std::string lopsided = std::string(SPLITSUM_TEST_DATA) + "/panoramas/lopsided.exr";

struct Layout {
    std::vector<std::string> options;
    double (*u)(double x, double z);  ///< where the horizontal direction lies in the image
};

double wrapped(double u) { return u - std::floor(u); }

const Layout layouts[] = {
    {{}, [](double x, double z) { return 0.5 + std::atan2(x, z) / (2 * pi); }},
    {{"--convention", "khronos-sampler"},
     [](double x, double z) { return 0.5 + std::atan2(z, x) / (2 * pi); }},
    {{"--convention", "cmgen"},
     [](double x, double z) { return 0.5 + std::atan2(-x, z) / (2 * pi); }},
    // The middle of the image moves from +Z towards +X by a twelfth of a turn.
    {{"--rotate", "30"},
     [](double x, double z) { return 0.5 + std::atan2(x, z) / (2 * pi) - 1 / 12.0; }},
    {{"--mirror"}, [](double x, double z) { return 0.5 - std::atan2(x, z) / (2 * pi); }},
    // Mirrored first, then turned.
    {{"--mirror", "--rotate", "30"},
     [](double x, double z) { return 0.5 - (std::atan2(x, z) / (2 * pi) - 1 / 12.0); }},
    {{"--convention", "khronos-sampler", "--rotate", "-90"},
     [](double x, double z) { return 0.5 + std::atan2(z, x) / (2 * pi) + 0.25; }},
};

// The panorama's red is its own u and its green its own v, so that a lookup tells where it came from.
TEST(Orientation, IsWhatTheFormulasSay) {
    const TemporaryFolder folder;
    const auto panorama = folder / "uv.pfm";
    write_panorama(panorama, 128, [](double u, double v) { return Vec3(u, v, 0.25); });
    for (const Layout& layout : layouts) {
        const auto output = folder / "cube.ktx2";
        std::vector<std::string> arguments = {
            panorama.string(), "-o", output.string(), "--size", "16",
            "--levels",        "1",  "--format",      "rgba32f"};
        arguments.insert(arguments.end(), layout.options.begin(), layout.options.end());
        const auto run = run_tool("splitsum-specular", arguments);
        ASSERT_EQ(run.exit_code, 0) << run.err;
        const Cubemap cube = levels_in(output).at(0);
        int compared = 0;
        for (int i = 0; i < 500; ++i) {
            const double v = std::acos(1 - (i + 0.5) / 250) / pi;
            const double azimuth = 2 * pi * 0.618034 * i;
            const Vec3d d(std::sin(pi * v) * std::sin(azimuth), std::cos(pi * v),
                          std::sin(pi * v) * std::cos(azimuth));
            const FacePoint at = face_point_towards(d);
            const int x = std::min(int(at.s * 16), 15), y = std::min(int(at.t * 16), 15);
            const Vec3d middle = direction_of_texel(at.face, x, y, 16);
            const double u = wrapped(layout.u(middle.x, middle.z));
            const bool seam = u < 0.06 || u > 0.94, pole = std::abs(middle.y) > 0.9;
            if (seam || pole) continue;  // there the mean over a texel is none of its points
            ++compared;
            const Vec3 seen = cube.at(at.face, x, y);
            ASSERT_NEAR(seen.x, u, 4e-3) << layout.options.size() << " " << i;
            ASSERT_NEAR(seen.y, std::acos(middle.y) / pi, 4e-3);
        }
        EXPECT_GT(compared, 350);
    }
}

TEST(Orientation, TravelsInTheFile) {
    const TemporaryFolder folder;
    for (const Layout& layout : layouts) {
        std::string name = "cube";
        for (const std::string& option : layout.options) name += option;
        SCOPED_TRACE(name);
        for (const char* tool : {"splitsum-specular", "splitsum-irradiance"}) {
            const std::string output = (folder / (name + ".ktx2")).string();
            std::vector<std::string> arguments = {lopsided, "-o",       output,     "--size",
                                                  "8",      "--method", "reference"};
            if (tool == std::string("splitsum-specular"))
                arguments.insert(arguments.end(), {"--levels", "2"});
            arguments.insert(arguments.end(), layout.options.begin(), layout.options.end());
            ASSERT_EQ(run_tool(tool, arguments).exit_code, 0);
            const std::vector<std::string> compare = {output, "--panorama", lopsided, "--limit",
                                                      "rel_rms=2e-3"};
            const auto right = run_tool("splitsum-compare", compare);
            EXPECT_EQ(right.exit_code, 0) << right.out << right.err;
            if (!layout.options.empty()) continue;
            auto turned = compare;  // what the user says overrules what the file says
            turned.insert(turned.end(), {"--rotate", "5"});
            EXPECT_EQ(run_tool("splitsum-compare", turned).exit_code, 1);
        }
    }
}

TEST(Orientation, HoldsForHarmonicsToo) {
    const TemporaryFolder folder;
    for (const Layout& layout : layouts) {
        const std::string output = (folder / "harmonics.json").string();
        std::vector<std::string> arguments = {lopsided, "-o", output, "--order", "12"};
        arguments.insert(arguments.end(), layout.options.begin(), layout.options.end());
        ASSERT_EQ(run_tool("splitsum-irradiance", arguments).exit_code, 0);
        const auto run = run_tool("splitsum-compare",
                                  {output, "--panorama", lopsided, "--limit", "rel_rms=2e-3"});
        EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
    }
}

TEST(Exposure, IsAFactorAndTravelsInTheFile) {
    const TemporaryFolder folder;
    const std::string plain = (folder / "plain.ktx2").string();
    const std::string bright = (folder / "bright.ktx2").string();
    const std::vector<std::string> common = {lopsided,   "--size",    "8",       "--levels",
                                             "3",        "--format",  "rgba32f", "--method",
                                             "filtered", "--samples", "256"};
    for (const auto& [output, stops] : {std::pair{plain, "0"}, {bright, "2"}}) {
        auto arguments = common;
        arguments.insert(arguments.end(), {"-o", output, "--exposure", stops});
        ASSERT_EQ(run_tool("splitsum-specular", arguments).exit_code, 0);
    }
    const auto dark_levels = levels_in(plain), bright_levels = levels_in(bright);
    for (size_t level = 0; level < 3; ++level)
        for (size_t i = 0; i < dark_levels[level].texels.size(); ++i)
            ASSERT_LT(length(bright_levels[level].texels[i] - 4.0f * dark_levels[level].texels[i]),
                      1e-6f * length(bright_levels[level].texels[i]));
    // The figures would be 0.75 if the panorama were read as it is.
    const auto run =
        run_tool("splitsum-compare", {bright, "--panorama", lopsided, "--limit", "0.02"});
    EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
    const auto as_is = run_tool(
        "splitsum-compare", {bright, "--panorama", lopsided, "--limit", "0.02", "--exposure", "0"});
    EXPECT_EQ(as_is.exit_code, 1) << as_is.out;
}

}  // namespace
}  // namespace splitsum::tests
