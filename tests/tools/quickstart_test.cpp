// What quickstart does once programs are built: previews of what was baked, and where everything is.
#include "support/temporary_folder.h"
#include "tools/programs.h"

namespace splitsum::tests {
namespace {

namespace fs = std::filesystem;

const std::string panoramas = std::string(SPLITSUM_TEST_DATA) + "/panoramas";

class Quickstart : public testing::Test {
protected:
    // As after a build: the log is older than what is baked next.
    Quickstart() {
        write_bytes(folder_ / "log", "");
        fs::last_write_time(folder_ / "log",
                            fs::file_time_type::clock::now() - std::chrono::seconds(10));
    }

    void bake(const std::vector<std::string>& inputs, const std::string& output = "out") {
        std::vector<std::string> arguments = inputs;
        for (const std::string& more :
             {std::string("-o"), (folder_ / output).string(), std::string("--size"),
              std::string("16"), std::string("--levels"), std::string("3"),
              std::string("--table-size"), std::string("16"), std::string("--probes"),
              std::string("1"), std::string("--no-picture")})
            arguments.push_back(more);
        const ProgramResult run = run_tool("splitsum-bake", arguments);
        ASSERT_EQ(run.exit_code, 0) << run.err;
    }

    /// Runs functions of quickstart on the folder out, the arguments being those of `bake`.
    ProgramResult run(const std::string& functions, std::vector<std::string> arguments) const {
        const std::string bin = SPLITSUM_BIN;
        std::vector<std::string> command = {
            "bash",
            "-c",
            R"(source "$1"; build=$2; log=$3; out=$4; shift 4; )" + functions,
            "bash",
            SPLITSUM_QUICKSTART,
            bin.substr(0, bin.rfind('/')),
            (folder_ / "log").string(),
            (folder_ / "out").string()};
        command.insert(command.end(), arguments.begin(), arguments.end());
        return run_program(command);
    }

    /// Rows of the preview of a panorama: 320 alone, 960 with truth and difference.
    unsigned preview_height(const std::string& name) const {
        const std::string bytes = bytes_of(folder_ / "out" / name / "preview.png");
        if (bytes.size() < 24) return 0;
        return 256u * uint8_t(bytes[22]) + uint8_t(bytes[23]);
    }

    TemporaryFolder folder_;
};

TEST_F(Quickstart, DrawsAPreviewBesideTheTruth) {
    const std::string file = panoramas + "/lopsided.exr";
    bake({file});
    const ProgramResult drawn = run(R"(draw_previews "$out" "$@"; name_results "$out" "$@")",
                                    {file, "-o", (folder_ / "out").string()});
    EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
    EXPECT_EQ(drawn.out, "");
    EXPECT_EQ(preview_height("lopsided"), 960u);
    EXPECT_NE(drawn.err.find("picture of spheres in this light is " +
                             (folder_ / "out/lopsided/preview.png").string()),
              std::string::npos)
        << drawn.err;
    EXPECT_NE(drawn.err.find((folder_ / "out/lopsided/preview.html").string()), std::string::npos)
        << drawn.err;
    EXPECT_TRUE(fs::exists(folder_ / "out/lopsided/preview.html"));
}

TEST_F(Quickstart, FindsPanoramasInFoldersAndDoesWithoutThoseItDoesNotSee) {
    fs::create_directory(folder_ / "skies");
    fs::copy(panoramas + "/one_texel.exr", folder_ / "skies/one_texel.exr");
    bake({(folder_ / "skies").string(), panoramas + "/lopsided.exr"});
    const ProgramResult drawn =
        run(R"(draw_previews "$out" "$@")", {(folder_ / "skies").string(), "--manifest", "a.toml"});
    EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
    EXPECT_EQ(preview_height("one_texel"), 960u);
    EXPECT_EQ(preview_height("lopsided"), 320u);
}

// Of what was baked before only what is named, and where a preview is missing.
TEST_F(Quickstart, LeavesOlderBakesAloneUnlessTheyAreNamed) {
    const std::string named = panoramas + "/lopsided.exr";
    bake({named, panoramas + "/one_texel.exr"});
    fs::last_write_time(folder_ / "log",
                        fs::file_time_type::clock::now() + std::chrono::seconds(10));
    const std::string functions = R"(draw_previews "$out" "$@"; name_results "$out" "$@")";
    const ProgramResult none = run(functions, {"--manifest", "a.toml"});
    EXPECT_EQ(none.exit_code, 0) << none.err;
    EXPECT_EQ(none.err, "");
    EXPECT_EQ(run(functions, {named}).exit_code, 0);
    EXPECT_EQ(preview_height("lopsided"), 960u);
    EXPECT_FALSE(fs::exists(folder_ / "out/one_texel/preview.png"));

    write_bytes(folder_ / "out/lopsided/preview.png", "kept");
    const ProgramResult again = run(functions, {named});
    EXPECT_EQ(bytes_of(folder_ / "out/lopsided/preview.png"), "kept");
    EXPECT_NE(again.err.find((folder_ / "out/lopsided/preview.png").string()), std::string::npos)
        << again.err;
}

TEST_F(Quickstart, ReadsThePanoramaAsTheBakeDid) {
    const ProgramResult options =
        run(R"(reading_options "$@")", {"a.exr", "--layer", "fill", "--colorspace=ACEScg", "-o",
                                        "out", "--repair", "--size", "64"});
    EXPECT_EQ(options.out, "--layer\nfill\n--colorspace=ACEScg\n--repair\n");
}

// A failure to draw is told, and is no failure of the bake.
TEST_F(Quickstart, SaysWhereThereIsNoPreview) {
    bake({panoramas + "/lopsided.exr"});
    fs::remove(folder_ / "out/brdf.ktx2");
    const ProgramResult drawn = run(R"(draw_previews "$out" "$@")", {panoramas + "/lopsided.exr"});
    EXPECT_EQ(drawn.exit_code, 0);
    EXPECT_NE(drawn.err.find("there is no preview of lopsided"), std::string::npos) << drawn.err;
}

}  // namespace
}  // namespace splitsum::tests
