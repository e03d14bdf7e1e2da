// splitsum-preview as a user runs it: pictures, figures, refusals, interruption.
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "support/temporary_folder.h"
#include "tools/programs.h"

namespace splitsum::tests {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

const std::string tool = "splitsum-preview";
const std::string data = SPLITSUM_TEST_DATA;
const std::string panorama = data + "/panoramas/lopsided.exr";

/// Width and height as a PNG's header says them; nothing where it is no PNG.
std::pair<unsigned, unsigned> png_size(const fs::path& file) {
    const std::string bytes = bytes_of(file);
    if (bytes.size() < 24 || bytes.substr(1, 3) != "PNG") return {0, 0};
    const auto number = [&](size_t at) {
        unsigned value = 0;
        for (size_t i = at; i < at + 4; ++i) value = 256 * value + uint8_t(bytes[i]);
        return value;
    };
    return {number(16), number(20)};
}

/// A small bake of the lopsided sky.
class PreviewTool : public testing::Test {
protected:
    void bake(const Arguments& more = {}, const std::string& levels = "4") {
        Arguments arguments = {panorama, "-o", (folder_ / "out").string(), "--levels", levels};
        for (const char* argument : {"--size", "32", "--irradiance-size", "8", "--table-size", "32",
                                     "--probes", "2", "--no-picture", "--force"})
            arguments.emplace_back(argument);
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult run = run_tool("splitsum-bake", arguments);
        ASSERT_EQ(run.exit_code, 0) << run.err;
    }

    /// The spheres of --json beside a truth of little noise.
    Json spheres(const std::string& folder, const std::string& source) const {
        const ProgramResult run =
            preview({folder, "-o", picture(), "--size", "105x30", "--panorama", source, "--truth",
                     "--noise", "0.02", "--probes", "2", "--json"});
        EXPECT_EQ(run.exit_code, 0) << run.err;
        const Json result = Json::parse(run.out, nullptr, false);
        return result.is_discarded() ? Json::array() : result["spheres"];
    }

    std::string baked() const { return (folder_ / "out/lopsided").string(); }
    std::string picture(const std::string& name = "picture.png") const {
        return (folder_ / name).string();
    }

    /// The arguments of a small picture of the bake, and more of them.
    Arguments small(const Arguments& more = {}) const {
        Arguments arguments = {baked(), "-o", picture(), "--size", "70x20"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }

    ProgramResult preview(const Arguments& arguments) const { return run_tool(tool, arguments); }

    void expect_refused(const Arguments& arguments, int exit_code, const std::string& says) const {
        const auto before = snapshot_of(folder_.path());
        const ProgramResult run = preview(arguments);
        expect_failure(tool, run, exit_code);
        EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
        EXPECT_EQ(snapshot_of(folder_.path()), before);
    }

    TemporaryFolder folder_;
};

TEST_F(PreviewTool, WritesAPictureOfTheSizeAskedFor) {
    bake();
    const ProgramResult run = preview(small());
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out, picture() + "\n");
    EXPECT_EQ(png_size(picture()), std::pair(70u, 20u));
    ASSERT_EQ(preview({baked(), "-o", picture()}).exit_code, 0);
    EXPECT_EQ(png_size(picture()), std::pair(1024u, 512u));
}

TEST_F(PreviewTool, StacksTheTruthAndTheDifferenceBelow) {
    bake();
    const ProgramResult run =
        preview(small({"--panorama", panorama, "--truth", "--noise", "0.2", "--probes", "2"}));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(png_size(picture()), std::pair(70u, 60u));
    EXPECT_NE(run.out.find("pictures: baked, truth, difference\n"), std::string::npos) << run.out;
}

TEST_F(PreviewTool, WritesLayersOfSceneLinearLight) {
    bake();
    const std::string exr = picture("picture.exr");
    Arguments arguments = {baked(), "-o", exr, "--size", "70x20"};
    ASSERT_EQ(preview(arguments).exit_code, 0);
    const std::string alone = bytes_of(exr).substr(0, 2000);
    EXPECT_EQ(alone.substr(0, 4), "\x76\x2f\x31\x01");
    EXPECT_EQ(alone.find("baked.R"), std::string::npos);
    arguments.insert(arguments.end(), {"--panorama", panorama, "--truth", "--noise", "0.2",
                                       "--no-verify", "--json"});
    const ProgramResult run = preview(arguments);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(Json::parse(run.out)["pictures"], (Arguments{"baked", "truth", "standard_error"}));
    const std::string layers = bytes_of(exr).substr(0, 2000);
    for (const char* channel : {"baked.R", "truth.G", "standard_error.B"})
        EXPECT_NE(layers.find(channel), std::string::npos) << channel;
}

TEST_F(PreviewTool, EveryOptionOfThePictureChangesIt) {
    bake();
    write_bytes(folder_ / "scene.json", R"({"spheres": [{"centre": [0, 0, 0]}]})");
    std::map<std::string, std::string> pictures;
    const Arguments options[] = {{},
                                 {"--view", "srgb"},
                                 {"--view", "filmic"},
                                 {"--exposure", "1"},
                                 {"--yaw", "90"},
                                 {"--pitch", "40"},
                                 {"--no-background"},
                                 {"--scene", picture("scene.json")}};
    for (const Arguments& more : options) {
        const ProgramResult run = preview(small(more));
        ASSERT_EQ(run.exit_code, 0) << run.err;
        const auto [same, is_new] =
            pictures.emplace(bytes_of(picture()), more.empty() ? "no option" : more[0]);
        EXPECT_TRUE(is_new) << more[0] << " gives the picture of " << same->second;
    }
    ASSERT_EQ(preview(small({"--view", "aces", "--exposure", "auto", "--background"})).exit_code,
              0);
    EXPECT_EQ(pictures[bytes_of(picture())], "no option");
}

TEST_F(PreviewTool, ShowsViewsOfAnOpenColorIOConfig) {
    bake();
    write_bytes(folder_ / "config.ocio",
                "ocio_profile_version: 2\nroles:\n  default: base\n  scene_linear: base\n"
                "displays:\n  Lamp:\n    - !<View> {name: Plain, colorspace: base}\n"
                "colorspaces:\n  - !<ColorSpace>\n    name: base\n");
    const std::string config = picture("config.ocio");
    ASSERT_EQ(preview(small()).exit_code, 0);
    const std::string aces = bytes_of(picture());
    const ProgramResult run = preview(small({"--view", "Lamp/Plain", "--ocio-config", config}));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(bytes_of(picture()), aces);
    expect_refused(small({"--view", "Lamp/Plane", "--ocio-config", config}), 2,
                   "did you mean Lamp/Plain?");
    expect_refused(small({"--view", "Lamp/Plain"}), 2, "there are: aces, filmic, srgb");
}

TEST_F(PreviewTool, FindsTheFiguresOfSplitsumCompare) {
    bake({"--rotate", "50", "--mirror", "--exposure", "-1.5", "--roughness", "filament"});
    const ProgramResult shown = preview(small({"--panorama", panorama, "--json"}));
    ASSERT_EQ(shown.exit_code, 0) << shown.err;
    const ProgramResult compared = run_tool(
        "splitsum-compare", {baked() + "/specular.ktx2", "--panorama", panorama, "--json"});
    ASSERT_EQ(compared.exit_code, 0) << compared.err;
    const Json ours = Json::parse(shown.out), theirs = Json::parse(compared.out);
    ASSERT_EQ(ours["levels"].size(), 4u);
    EXPECT_EQ(ours["levels"], theirs["levels"]);
    EXPECT_EQ(ours["between_texels_and_levels"], theirs["between_texels_and_levels"]);
    for (const Json& level : ours["levels"]) EXPECT_LT(level["rel_rms"], 2e-3);
    EXPECT_EQ(ours["notes"], Json::array());
}

// Fewer levels cost baked data alone: the split sum stays as wrong as it was.
TEST_F(PreviewTool, TellsBakedDataFromTheSplitSum) {
    bake();
    const Json many = spheres(baked(), panorama);
    bake({}, "2");
    const Json few = spheres(baked(), panorama);
    ASSERT_EQ(many.size(), 14u);
    ASSERT_EQ(few.size(), 14u);
    const Json &fine = many[10], &coarse = few[10];
    EXPECT_EQ(fine["name"], "metal 3");
    EXPECT_GT(coarse["baked_data"]["rel_rms"], 3 * double(fine["baked_data"]["rel_rms"]));
    EXPECT_GT(fine["approximation"]["rel_rms"], 0.01);
    EXPECT_EQ(fine["approximation"], coarse["approximation"]);
    EXPECT_GT(fine["pixels"], 20);
}

// Where light is the same everywhere, nothing is lost by splitting it, and all that is left are the
// rounding of half floats and a table of 32², 1 % at its rim of roughness 1.
TEST_F(PreviewTool, FindsNoApproximationInAWhiteFurnace) {
    std::string bytes = "PF\n16 8\n-1.0\n";
    const float light[3] = {0.5f, 0.25f, 2};
    for (int i = 0; i < 16 * 8; ++i)
        bytes.append(reinterpret_cast<const char*>(light), sizeof light);
    const std::string furnace = picture("furnace.pfm");
    write_bytes(furnace, bytes);
    const ProgramResult run = run_tool(
        "splitsum-bake", {furnace, "-o", (folder_ / "out").string(), "--size", "8", "--levels", "3",
                          "--irradiance-size", "4", "--table-size", "32", "--no-picture"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json found = spheres((folder_ / "out/furnace").string(), furnace);
    ASSERT_EQ(found.size(), 14u);
    for (const Json& sphere : found) {
        EXPECT_LT(sphere["approximation"]["rel_rms"], 1e-5) << sphere;
        EXPECT_LT(sphere["together"]["rel_rms"], 1.5e-2) << sphere;
    }
}

TEST_F(PreviewTool, NotesAnotherPanorama) {
    bake();
    const ProgramResult run =
        preview(small({"--panorama", data + "/panoramas/sun.exr", "--no-verify", "--json"}));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json result = Json::parse(run.out);
    ASSERT_EQ(result["notes"].size(), 1u);
    EXPECT_NE(std::string(result["notes"][0]).find("lopsided.exr"), std::string::npos);
    EXPECT_FALSE(result.contains("levels"));
}

TEST_F(PreviewTool, TakesFilesOneByOne) {
    bake();
    ASSERT_EQ(preview(small()).exit_code, 0);
    const std::string together = bytes_of(picture());
    const std::string table = picture("out/brdf.ktx2");
    const ProgramResult run = preview({"--specular", baked() + "/specular.ktx2", "--irradiance",
                                       baked() + "/irradiance.ktx2", "--table", table, "-o",
                                       picture(), "--size", "70x20"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(bytes_of(picture()), together);
    EXPECT_EQ(preview(small({"--irradiance", baked() + "/harmonics.json"})).exit_code, 0);
    EXPECT_NE(bytes_of(picture()), together);
    expect_refused({"--specular", baked() + "/specular.ktx2", "-o", picture()}, 2, "--table");
}

TEST_F(PreviewTool, ReadsTablesOfTheSameMeaningOnly) {
    bake();
    ASSERT_EQ(preview(small()).exit_code, 0);
    const std::string usual = bytes_of(picture());
    const std::string table = picture("table.ktx2");
    const auto with_table = [&](const Arguments& options) {
        Arguments arguments = {"-o", table, "--size", "32", "--format", "rg32f"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        EXPECT_EQ(run_tool("splitsum-brdf", arguments).exit_code, 0);
        return preview(small({"--table", table}));
    };
    ASSERT_EQ(with_table({}).exit_code, 0);
    const std::string floats = bytes_of(picture());
    for (const Arguments& options :
         {Arguments{"--flip"}, {"--axes", "roughness-nv"}, {"--table", "ggx-multiscatter"}}) {
        const ProgramResult run = with_table(options);
        EXPECT_EQ(run.exit_code, 0) << run.err;
        EXPECT_EQ(bytes_of(picture()), floats) << options[0];
    }
    for (const Arguments& options :
         {Arguments{"--layout", "edge"}, {"--roughness-axis", "alpha"}, {"--table", "charlie"}}) {
        const ProgramResult run = with_table(options);
        expect_failure(tool, run, 5);
        EXPECT_NE(run.err.find("splitsum-brdf"), std::string::npos) << run.err;
    }
}

TEST_F(PreviewTool, RefusesWhatCannotWork) {
    bake();
    write_bytes(folder_ / "bad.json", R"({"spheres": [{"centre": [0, 0]}]})");
    write_bytes(folder_ / "no.json", "spheres");
    expect_refused({"-o", picture()}, 2, "BAKED is required");
    expect_refused({baked()}, 2, "--output");
    expect_refused({baked(), "-o", picture("picture.jpg")}, 2, ".png, .exr");
    expect_refused({baked(), "-o", "/proc/splitsum.png"}, 4, "cannot write /proc");
    expect_refused({baked(), "-o", picture("absent/picture.png")}, 4, "absent");
    expect_refused({(folder_ / "absent").string(), "-o", picture()}, 3, "absent");
    expect_refused({baked(), "-o", picture(), "--table", picture("absent.ktx2")}, 3, "absent.ktx2");
    expect_refused({baked(), "-o", picture(), "--specular", baked() + "/irradiance.ktx2"}, 5,
                   "not a specular chain");
    expect_refused(small({"--scene", picture("bad.json")}), 5, "three numbers");
    expect_refused(small({"--scene", picture("no.json")}), 3, "no.json");
    expect_refused(small({"--truth"}), 2, "--panorama");
    expect_refused(small({"--panorama", data + "/unusable/square.exr"}), 5, "square.exr");
    expect_refused(small({"--panorama", data + "/malformed/truncated.exr"}), 3, "truncated.exr");
}

TEST_F(PreviewTool, RefusesValuesOutOfRange) {
    bake();
    const Arguments calls[] = {
        {"--size", "70"},     {"--size", "70x"},     {"--size", "0x20"}, {"--size", "70x99999"},
        {"--size", "70x20x"}, {"--yaw", "east"},     {"--pitch", "91"},  {"--exposure", "bright"},
        {"--view", "acse"},   {"--exposure", "1e9"}, {"--probes", "0"},  {"--yaw", "nan"},
    };
    for (const Arguments& call : calls) {
        SCOPED_TRACE(call[0] + " " + call[1]);
        expect_refused({baked(), "-o", picture(), call[0], call[1]}, 2, call[1]);
    }
    for (const Arguments& call : {Arguments{"--noise", "0"}, {"--time-limit", "-1"}})
        expect_refused(small({"--panorama", panorama, "--truth", call[0], call[1]}), 2, call[0]);
}

TEST_F(PreviewTool, GivesTheSameBytesForAnyNumberOfThreads) {
    bake();
    for (const char* name : {"picture.png", "picture.exr"}) {
        std::string first;
        for (const char* threads : {"1", "7"}) {
            const ProgramResult run = preview({baked(), "-o", picture(name), "--size", "70x20",
                                               "--panorama", panorama, "--truth", "--noise", "0.1",
                                               "--probes", "2", "--json", "--threads", threads});
            ASSERT_EQ(run.exit_code, 0) << run.err;
            const std::string all = run.out + bytes_of(picture(name));
            if (first.empty()) first = all;
            EXPECT_TRUE(all == first) << name;
        }
    }
}

// The least noise there may be takes minutes: whoever stops it gets what there is.
TEST_F(PreviewTool, InterruptedItWritesThePictureSoFar) {
    bake();
    const std::string err = picture("err");
    const ProgramResult run = run_program(
        {"/bin/sh", "-c",
         std::string(SPLITSUM_BIN) + "/" + tool + " '" + baked() + "' -o '" + picture() +
             "' --size 280x80 --panorama '" + panorama + "' --truth --noise 1e-4 2>'" + err +
             "' & child=$!; while ! grep -q integrating '" + err +
             "'; do sleep 0.05; done; sleep 0.5; kill -INT $child; wait $child"});
    EXPECT_EQ(run.exit_code, 130);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(bytes_of(err).find("has the picture so far"), std::string::npos) << bytes_of(err);
    EXPECT_EQ(png_size(picture()), std::pair(280u, 240u));
}

TEST_F(PreviewTool, StopsAtATimeLimit) {
    bake();
    const ProgramResult run =
        preview({baked(), "-o", picture(), "--size", "280x80", "--panorama", panorama, "--truth",
                 "--noise", "1e-4", "--time-limit", "0.5", "--no-verify", "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(Json::parse(run.out)["truth"]["ended"], "out_of_time");
}

// What was there before survives a disk on which nothing fits.
TEST_F(PreviewTool, KeepsAnOlderPictureWhereANewOneCannotGrow) {
    bake();
    write_bytes(picture(), "an older picture");
    const ProgramResult run =
        run_program({"/bin/sh", "-c", R"(ulimit -f 1 && exec "$@")", "sh",
                     std::string(SPLITSUM_BIN) + "/" + tool, baked(), "-o", picture(), "--quiet"});
    EXPECT_EQ(run.exit_code, 4) << run.err;
    EXPECT_EQ(bytes_of(picture()), "an older picture");
}

}  // namespace
}  // namespace splitsum::tests
