// Inputs, outputs and options that cannot work, against every program that bakes: the documented
// exit code, one message, no new file, and nothing lost that was there before.
#include <sys/mount.h>

#include <tuple>

#include "support/temporary_folder.h"
#include "tools/programs.h"

namespace splitsum::tests {
namespace {

namespace fs = std::filesystem;

const std::string data = SPLITSUM_TEST_DATA;
const std::string good_panorama = data + "/panoramas/sunset.exr";

bool writes_a_folder(const std::string& tool) { return tool == "splitsum-bake"; }

class BakingTool : public testing::TestWithParam<std::string> {
protected:
    BakingTool() {
        fs::create_directory(folder_ / "older");
        for (const char* name : {"out.ktx2", "specular.ktx2", "report.json"})
            write_bytes(folder_ / "older" / name, "an older result");
        before_ = snapshot_of(folder_.path());
    }

    /// Where the tool's output goes: over an older one.
    std::string older_output() const {
        return (writes_a_folder(GetParam()) ? folder_ / "older" : folder_ / "older" / "out.ktx2")
            .string();
    }

    /// Runs the tool, expects it to fail, and expects the files to be as they were.
    ProgramResult expect_refusal(const std::vector<std::string>& arguments, int exit_code) {
        ProgramResult run = run_tool(GetParam(), arguments);
        expect_failure(GetParam(), run, exit_code);
        EXPECT_EQ(snapshot_of(folder_.path()), before_);
        return run;
    }

    TemporaryFolder folder_;
    std::map<std::string, std::string> before_;
};

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(BakingTool);
INSTANTIATE_TEST_SUITE_P(Tools, BakingTool, testing::ValuesIn(baking_tools()), test_name);

// Without this, a tool that always fails would pass the rest.
TEST_P(BakingTool, BakesAGoodPanorama) {
    const ProgramResult run = run_tool(GetParam(), {good_panorama, "-o", older_output()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(snapshot_of(folder_.path()), before_);
    for (const auto& [file, bytes] : snapshot_of(folder_.path()))
        EXPECT_FALSE(file.ends_with(".part")) << file;
}

struct BadInput {
    const char* file;  ///< below test_data
    int exit_code;
};

TEST_P(BakingTool, RefusesABadInput) {
    const BadInput inputs[] = {
        {"there_is_no_such_file.exr", 3},
        {"malformed", 3},
        {"malformed/empty.hdr", 3},
        {"malformed/truncated.hdr", 3},
        {"malformed/truncated.exr", 3},
        {"malformed/wrong_magic.exr", 3},
        {"malformed/zero_by_zero.hdr", 3},
        {"malformed/absurd_header.hdr", 3},
        {"malformed/absurd_header.exr", 3},
        {"malformed/text.exr", 3},
        {"unusable/square.exr", 5},
        {"unusable/nan.exr", 5},
        {"unusable/inf.exr", 5},
        {"unusable/negative.exr", 5},
        {"unusable/1x1.exr", 5},
    };
    for (const BadInput& input : inputs) {
        SCOPED_TRACE(input.file);
        // A library, to splitsum-bake.
        if (GetParam() == "splitsum-bake" && input.file == std::string("malformed")) continue;
        const fs::path path = data + "/" + input.file;
        const auto run = expect_refusal({path.string(), "-o", older_output()}, input.exit_code);
        EXPECT_NE(run.err.find(path.filename().string()), std::string::npos) << run.err;
    }
}

TEST_P(BakingTool, RefusesOptionsThatCannotWork) {
    const std::vector<std::string> calls[] = {
        {"--size", "0"},       {"--size", "-4"},         {"--size", "1e3"},     {"--size", "99999"},
        {"--samples", "-1"},   {"--samples", "0"},       {"--method", "guess"}, {"--format", "png"},
        {"--format", "rg16f"}, {"--convention", "none"}, {"--rotate", "east"},  {"--rotate", "nan"},
        {"--exposure", "inf"}, {"--sise", "64"},         {"--seed", "-1"},
    };
    for (const std::vector<std::string>& call : calls) {
        SCOPED_TRACE(call[0] + " " + call[1]);
        expect_refusal({good_panorama, "-o", older_output(), call[0], call[1]}, 2);
    }
}

TEST_P(BakingTool, NeedsAnOutputAndAnInput) {
    const auto no_output = expect_refusal({good_panorama}, 2);
    EXPECT_NE(no_output.err.find("--output"), std::string::npos) << no_output.err;
    const auto no_input = expect_refusal({"-o", older_output()}, 2);
    EXPECT_NE(no_input.err.find("PANORAMA"), std::string::npos) << no_input.err;
}

TEST_P(BakingTool, RefusesMoreLevelsThanTheSizeHas) {
    if (GetParam() == "splitsum-irradiance") GTEST_SKIP() << "has no levels";
    for (const auto& [size, levels] : {std::pair{"16", "6"}, {"1", "2"}, {"256", "99"}}) {
        SCOPED_TRACE(size);
        expect_refusal({good_panorama, "-o", older_output(), "--size", size, "--levels", levels},
                       2);
    }
    expect_refusal({good_panorama, "-o", older_output(), "--levels", "3", "--roughness", "0,1"}, 2);
    expect_refusal({good_panorama, "-o", older_output(), "--roughness", "round"}, 2);
}

// Nobody may create files there, root included.
TEST_P(BakingTool, ReportsAFolderThatCannotBeWritten) {
    const char* output = writes_a_folder(GetParam()) ? "/proc/splitsum" : "/proc/splitsum.ktx2";
    expect_refusal({good_panorama, "-o", output}, 4);
}

TEST_P(BakingTool, ReportsAnOutputOfTheWrongKind) {
    if (writes_a_folder(GetParam())) {
        expect_refusal({good_panorama, "-o", (folder_ / "older" / "out.ktx2").string()}, 4);
        return;
    }
    expect_refusal({good_panorama, "-o", (folder_ / "missing" / "out.ktx2").string()}, 4);
    fs::create_symlink("/dev/full", folder_ / "full.ktx2");
    expect_refusal({good_panorama, "-o", (folder_ / "full.ktx2").string()}, 4);
    EXPECT_TRUE(fs::is_symlink(folder_ / "full.ktx2"));
}

// What a full disk does, for any user: files may not grow over 512 bytes.
TEST_P(BakingTool, ReportsAFileThatCannotGrow) {
    const ProgramResult run = run_program({"/bin/sh", "-c", R"(ulimit -f 1 && exec "$@")", "sh",
                                           std::string(SPLITSUM_BIN) + "/" + GetParam(),
                                           good_panorama, "-o", older_output(), "--quiet"});
    EXPECT_EQ(run.exit_code, 4) << run.err;
    EXPECT_EQ(snapshot_of(folder_.path()), before_);
}

TEST_P(BakingTool, ReportsAFullDisk) {
    const fs::path disk = folder_ / "disk";
    fs::create_directory(disk);
    if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=8k") != 0)
        GTEST_SKIP() << "mounting a small disk needs root: " << std::strerror(errno);
    const fs::path output = writes_a_folder(GetParam()) ? disk : disk / "out.ktx2";
    const ProgramResult run = run_tool(GetParam(), {good_panorama, "-o", output.string()});
    EXPECT_EQ(run.exit_code, 4) << run.err;
    EXPECT_EQ(run.err_lines(), 1u) << run.err;
    EXPECT_EQ(snapshot_of(folder_.path()), before_);
    umount2(disk.c_str(), MNT_DETACH);
}

}  // namespace
}  // namespace splitsum::tests
