// splitsum-brdf as a user runs it.
#include "support/temporary_folder.h"
#include "tools/programs.h"

namespace splitsum::tests {
namespace {

constexpr const char* tool = "splitsum-brdf";

TEST(SplitsumBrdf, WritesATableInEveryFormat) {
    const TemporaryFolder folder;
    const struct {
        const char* format;
        size_t bytes_per_texel;
    } formats[] = {{"rg16f", 4}, {"rg32f", 8}};
    for (const auto& [format, bytes_per_texel] : formats) {
        const auto output = folder / (std::string(format) + ".ktx2");
        const auto run =
            run_tool(tool, {"-o", output.string(), "--size", "33", "--format", format});
        ASSERT_EQ(run.exit_code, 0) << run.err;
        const std::string file = bytes_of(output);
        EXPECT_EQ(file.substr(0, 12), "\xabKTX 20\xbb\r\n\x1a\n");
        EXPECT_GT(file.size(), 33 * 33 * bytes_per_texel);
        EXPECT_LT(file.size(), 33 * 33 * bytes_per_texel + 4096);
    }
}

TEST(SplitsumBrdf, WritesTheSameBytesForAnyNumberOfThreads) {
    const TemporaryFolder folder;
    for (const char* threads : {"1", "3", "8"}) {
        const auto run = run_tool(tool, {"-o", (folder / threads).string() + ".ktx2", "--size",
                                         "61", "--threads", threads});
        ASSERT_EQ(run.exit_code, 0) << run.err;
    }
    const std::string one = bytes_of(folder / "1.ktx2");
    EXPECT_FALSE(one.empty());
    EXPECT_TRUE(one == bytes_of(folder / "3.ktx2"));
    EXPECT_TRUE(one == bytes_of(folder / "8.ktx2"));
}

TEST(SplitsumBrdf, GeometryTermsDiffer) {
    const TemporaryFolder folder;
    std::map<std::string, std::string> tables;
    for (const char* term : {"height-correlated", "schlick-half", "schlick-sqrt"}) {
        const auto output = (folder / term).string() + ".ktx2";
        const auto run = run_tool(tool, {"-o", output, "--size", "16", "--geometry", term});
        ASSERT_EQ(run.exit_code, 0) << run.err;
        tables[bytes_of(output)] = term;
    }
    EXPECT_EQ(tables.size(), 3u);
}

TEST(SplitsumBrdf, RefusesWhatCannotWork) {
    const TemporaryFolder folder;
    const std::string output = (folder / "out.ktx2").string();
    write_bytes(output, "an older result");
    const auto before = snapshot_of(folder.path());
    const struct {
        std::vector<std::string> arguments;
        int exit_code;
    } calls[] = {
        {{"-o", output, "--size", "0"}, 2},
        {{"-o", output, "--size", "999999"}, 2},
        {{"-o", output, "--samples", "-1"}, 2},
        {{"-o", output, "--geometry", "flat"}, 2},
        {{"-o", output, "--format", "rgba16f"}, 2},
        {{"-o", output, "--zstd-level", "23"}, 2},
        {{"-o", output, "surplus"}, 2},
        {{"-o", ""}, 2},
        {{"-o", (folder / "out.nothing").string()}, 2},
        {{"-o", "/proc/splitsum.ktx2"}, 4},
        {{"-o", (folder / "missing" / "out.ktx2").string()}, 4},
    };
    for (const auto& [arguments, exit_code] : calls) {
        SCOPED_TRACE(arguments.back());
        expect_failure(tool, run_tool(tool, arguments), exit_code);
        EXPECT_EQ(snapshot_of(folder.path()), before);
    }
}

// OpenImageIO brings some 260 shared libraries and a fifth of a second before main.
TEST(SplitsumBrdf, DoesNotLoadOpenImageIO) {
    const ProgramResult run = run_program({"ldd", std::string(SPLITSUM_BIN) + "/" + tool});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find("libtbb"), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find("OpenImageIO"), std::string::npos) << run.out;
    EXPECT_EQ(run.out.find("OpenColorIO"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace splitsum::tests
