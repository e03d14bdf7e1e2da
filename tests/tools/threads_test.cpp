// The same call gives the same bytes for any number of threads: builds can be cached, results diffed.
#include "support/temporary_folder.h"
#include "tools/programs.h"

namespace splitsum::tests {
namespace {

const std::string panorama = std::string(SPLITSUM_TEST_DATA) + "/panoramas/lopsided.exr";

// Runs the tool with 1 and with 7 threads into folders of their own and compares all files.
void expect_same_files(const std::string& tool, std::vector<std::string> arguments,
                       const std::string& output, size_t file_count) {
    std::map<std::string, std::string> files[2];
    int run = 0;
    for (const char* threads : {"1", "7"}) {
        const TemporaryFolder folder;
        auto all = arguments;
        for (const std::string& more : {std::string("-o"), (folder / output).string(),
                                        std::string("--threads"), std::string(threads)})
            all.push_back(more);
        const ProgramResult result = run_tool(tool, all);
        ASSERT_EQ(result.exit_code, 0) << result.err;
        // But for what splitsum-bake notes of its sources, which has a time in it.
        for (const auto& [name, bytes] : snapshot_of(folder.path()))
            if (!name.ends_with("/.source"))
                files[run][std::filesystem::relative(name, folder.path()).string()] = bytes;
        ++run;
    }
    ASSERT_EQ(files[0].size(), file_count);
    for (const auto& [name, bytes] : files[0]) {
        EXPECT_FALSE(bytes.empty()) << name;
        EXPECT_TRUE(bytes == files[1][name]) << name << " differs: " << arguments.back();
    }
}

TEST(SameBytes, OfABakeOfTwoPanoramas) {
    const std::string other = std::string(SPLITSUM_TEST_DATA) + "/panoramas/one_texel.exr";
    expect_same_files("splitsum-bake",
                      {panorama, other, "--size", "32", "--levels", "6", "--irradiance-size", "8",
                       "--table-size", "31", "--probes", "8"},
                      "out", 13);
}

TEST(SameBytes, OfSpecularByEveryMethod) {
    // riemann filters diffuse light alone; the others are those that --help lists.
    const std::string help = run_tool("splitsum-specular", {"--help"}).out;
    int methods = 0;
    for (const char* method : {"reference", "importance", "filtered", "mis", "spectral"}) {
        if (help.find(std::string("  ") + method + ": ") == std::string::npos) continue;
        ++methods;
        expect_same_files("splitsum-specular",
                          {panorama, "--size", "16", "--levels", "4", "--probes", "4",
                           "--rotate-samples", "--method", method},
                          "out.ktx2", 1);
    }
    EXPECT_EQ(methods, 5);
}

TEST(SameBytes, OfSpecularInEveryFormat) {
    const std::vector<std::string> common = {panorama, "--size",   "16", "--levels",
                                             "3",      "--probes", "0"};
    for (const char* format : {"rgba16f", "rgba32f", "rgb9e5", "b10g11r11"}) {
        auto arguments = common;
        arguments.insert(arguments.end(), {"--zstd", "--format", format});
        expect_same_files("splitsum-specular", arguments, "out.ktx2", 1);
    }
    for (const char* format : {"rgba16f", "rgba32f"}) {
        auto arguments = common;
        arguments.insert(arguments.end(), {"--format", format});
        expect_same_files("splitsum-specular", arguments, "out.exr", 1);
    }
}

TEST(SameBytes, OfIrradianceInEveryForm) {
    for (const char* output : {"out.ktx2", "out.exr", "out.json", "out.txt", "out.glsl"})
        expect_same_files("splitsum-irradiance",
                          {panorama, "--size", "8", "--probes", "4", "--window", "--order", "3"},
                          output, 1);
    expect_same_files("splitsum-irradiance",
                      {panorama, "--size", "8", "--probes", "4", "--method", "riemann"}, "out.ktx2",
                      1);
}

TEST(SameBytes, OfTables) {
    for (const char* output : {"out.ktx2", "out.exr"})
        expect_same_files("splitsum-brdf", {"--size", "63", "--format", "rg32f"}, output, 1);
}

}  // namespace
}  // namespace splitsum::tests
