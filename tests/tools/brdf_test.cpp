// splitsum-brdf as a user runs it.
#include <nlohmann/json.hpp>

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
    } formats[] = {{"rg16f", 4}, {"rg32f", 8}, {"rgba16f", 8}, {"rgba32f", 16}, {"rg16unorm", 4}};
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
        {{"-o", output, "--format", "rgb9e5"}, 2},
        {{"-o", output, "--size", "many"}, 2},
        {{"-o", output, "--size", "auto"}, 2},
        {{"-o", output, "--size", "auto", "--accuracy", "1e-6"}, 2},
        {{"-o", output, "--size", "64", "--accuracy", "1e-5"}, 2},
        {{"-o", output, "--size", "64", "--method", "importance", "--accuracy", "1e-3"}, 2},
        {{"-o", output, "--accuracy", "0"}, 2},
        {{"-o", output, "--size", "1", "--layout", "edge"}, 2},
        {{"-o", output, "--table", "gxx"}, 2},
        {{"-o", output, "--table", "ggx-fit"}, 2},
        {{"-o", output, "--axes", "sideways"}, 2},
        {{"-o", output, "--layout", "middle"}, 2},
        {{"-o", output, "--roughness-axis", "gloss"}, 2},
        {{"-o", output, "--preview", (folder / "out.jpg").string()}, 2},
        {{"-o", (folder / "out.glsl").string(), "--size", "128"}, 2},
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

std::string literal(const std::filesystem::path& path) { return "\"" + path.string() + "\""; }

// The headers that the tool writes compile on their own, and their lookups agree: with texels in the
// middle or at the edges, the axes either way round, roughness squared, rows upside down.
TEST(SplitsumBrdf, HeadersCompileAndAgree) {
    const TemporaryFolder folder;
    const std::vector<std::vector<std::string>> calls = {
        {"--size", "64"},
        {"--size", "64", "--layout", "edge", "--flip"},
        {"--size", "96", "--axes", "roughness-nv", "--roughness-axis", "alpha"},
        {"--table", "ggx-fit"},
        {"--table", "ggx-fit", "--geometry", "schlick-half"},
    };
    for (size_t i = 0; i < calls.size(); ++i) {
        SCOPED_TRACE(calls[i].back());
        const auto header = folder / ("table" + std::to_string(i) + ".hpp");
        std::vector<std::string> arguments = calls[i];
        arguments.insert(arguments.end(), {"-o", header.string()});
        const auto run = run_tool(tool, arguments);
        ASSERT_EQ(run.exit_code, 0) << run.err;
        const bool fit = calls[i][1] == "ggx-fit";
        const std::string name = fit ? "splitsum_ggx_fit" : "splitsum_ggx";
        // split_sum_exact at n·v = 0.6, r = 0.5; the formula's error is 0.015.
        const bool schlick = calls[i].back() == "schlick-half";
        const std::string a = schlick ? "0.77263f" : "0.860767f";
        const std::string b = schlick ? "0.009334f" : "0.010953f";
        const std::string limit = fit ? "0.015f" : "0.0003f";
        write_bytes(folder / "main.cpp",
                    "#include " + literal(header) + "\nint main() { float read[2]; " + name +
                        "::look_up(0.6f, 0.5f, read); return std::abs(read[0] - " + a + ") < " +
                        limit + " && std::abs(read[1] - " + b + ") < " + limit + " ? 0 : 1; }\n");
        const std::string program = (folder / "main").string();
        const auto compiled = run_program({"c++", "-std=c++17", "-Wall", "-Wextra", "-Werror", "-o",
                                           program, (folder / "main.cpp").string()});
        ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
        EXPECT_EQ(run_program({program}).exit_code, 0);
    }
}

TEST(SplitsumBrdf, GlslCompilesAsGlslAndAsEs) {
    const TemporaryFolder folder;
    const std::vector<std::vector<std::string>> calls = {
        {"--size", "16", "--layout", "edge", "--flip", "--axes", "roughness-nv"},
        {"--size", "16", "--table", "energy", "--roughness-axis", "alpha"},
        {"--table", "ggx-fit"},
        {"--table", "ggx-fit", "--geometry", "schlick-sqrt"},
        {"--size", "8", "--table", "charlie"},
    };
    for (const auto& call : calls) {
        SCOPED_TRACE(call.back());
        std::vector<std::string> arguments = call;
        arguments.insert(arguments.end(), {"-o", (folder / "table.glsl").string()});
        const auto run = run_tool(tool, arguments);
        ASSERT_EQ(run.exit_code, 0) << run.err;
        for (const char* version :
             {"#version 450\n", "#version 300 es\nprecision highp float;\n"}) {
            write_bytes(folder / "table.frag",
                        version + bytes_of(folder / "table.glsl") +
                            "out vec4 colour;\nvoid main() { colour = vec4(1.0); }\n");
            const auto compiled =
                run_program({"glslangValidator", (folder / "table.frag").string()});
            EXPECT_EQ(compiled.exit_code, 0) << compiled.out;
        }
    }
}

TEST(SplitsumBrdf, JsonAndPreviewSayWhatWasMade) {
    const TemporaryFolder folder;
    const auto run = run_tool(tool, {"-o", (folder / "t.json").string(), "--size", "9", "--json",
                                     "--preview", (folder / "t.png").string()});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto result = nlohmann::json::parse(run.out);
    EXPECT_LT(double(result["max_abs"]), 1e-6);
    EXPECT_GT(double(result["max_abs_between"]), double(result["max_abs"]));
    EXPECT_GT(double(result["max_abs_in_rim"]), double(result["max_abs"]));
    const auto file = nlohmann::json::parse(bytes_of(folder / "t.json"));
    EXPECT_EQ(file["values"].size(), 2u * 9 * 9);
    EXPECT_EQ(file["channel_names"], (std::vector<std::string>{"scale", "bias"}));
    EXPECT_EQ(file["metadata"]["splitsum.layout"], "centre");
    EXPECT_EQ(bytes_of(folder / "t.png").substr(1, 3), "PNG");
}

// What an engine expects of a table is its default, and an option on the command line is stronger.
TEST(SplitsumBrdf, KindsHaveDefaultsOfTheirOwn) {
    const TemporaryFolder folder;
    const auto metadata = [&](std::vector<std::string> arguments) {
        const auto path = folder / "t.json";
        arguments.insert(arguments.end(), {"--table", "ltc-disney", "-o", path.string()});
        const auto run = run_tool(tool, arguments);
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return nlohmann::json::parse(bytes_of(path));
    };
    const auto usual = metadata({});
    EXPECT_EQ(usual["width"], 64);
    EXPECT_EQ(usual["metadata"]["splitsum.layout"], "edge");
    EXPECT_EQ(usual["metadata"]["splitsum.axes_order"], "roughness-nv");
    const auto asked = metadata({"--size", "8", "--layout", "centre", "--axes", "nv-roughness"});
    EXPECT_EQ(asked["width"], 8);
    EXPECT_EQ(asked["metadata"]["splitsum.layout"], "centre");
    EXPECT_EQ(asked["metadata"]["splitsum.axes_order"], "nv-roughness");
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
