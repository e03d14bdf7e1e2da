// splitsum-chart as a user runs it: files whole or not at all, pictures or a reason why not.
#include <chrono>

#include "support/temporary_folder.h"
#include "tools/programs.h"

namespace splitsum::tests {
namespace {

const std::string tool = "splitsum-chart";
const std::string panorama = std::string(SPLITSUM_TEST_DATA) + "/panoramas/lopsided.exr";

std::vector<std::string> files_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

// A PATH on which nothing is found.
ProgramResult run_without_plotter(const std::filesystem::path& folder) {
    return run_program({"/usr/bin/env", "PATH=/nowhere", std::string(SPLITSUM_BIN) + "/" + tool,
                        panorama, "-o", folder.string(), "--quick", "--quiet"},
                       std::chrono::minutes(5));
}

TEST(ChartTool, WritesTheTablesAndSaysWhyThereAreNoPictures) {
    const TemporaryFolder folder;
    const ProgramResult run = run_without_plotter(folder / "out");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find("gnuplot-nox"), std::string::npos) << run.out;
    EXPECT_EQ(files_in(folder / "out"),
              (std::vector<std::string>{"chart.csv", "chart.gnuplot", "chart.html", "chart.json",
                                        "storage.csv"}));
    EXPECT_NE(bytes_of(folder / "out/chart.html").find("gnuplot-nox"), std::string::npos);
}

TEST(ChartTool, DrawsPicturesThatThePageCarries) {
    if (run_program({"gnuplot", "--version"}).exit_code != 0) GTEST_SKIP() << "no gnuplot";
    const TemporaryFolder folder;
    const ProgramResult run = run_program({std::string(SPLITSUM_BIN) + "/" + tool, panorama, "-o",
                                           (folder / "out").string(), "--quick", "--quiet"},
                                          std::chrono::minutes(5));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out, (folder / "out/chart.html").string() + "\n");
    EXPECT_EQ(files_in(folder / "out"),
              (std::vector<std::string>{"chart.csv", "chart.gnuplot", "chart.html", "chart.json",
                                        "chart.png", "chart.svg", "storage.csv", "storage.png",
                                        "storage.svg"}));
    EXPECT_EQ(bytes_of(folder / "out/chart.png").substr(0, 4), "\x89PNG");
    for (const char* word : {"spectral", "filtered", "milliseconds", "error"})
        EXPECT_NE(bytes_of(folder / "out/chart.svg").find(word), std::string::npos) << word;
    EXPECT_NE(bytes_of(folder / "out/chart.html").find("data:image/svg+xml;base64,"),
              std::string::npos);
}

TEST(ChartTool, KeepsWhatWasMeasuredWhenItIsInterrupted) {
    const TemporaryFolder folder;
    const ProgramResult run = run_program(
        {"/bin/sh", "-c",
         std::string(SPLITSUM_BIN) + "/" + tool + " " + panorama + " --quick -o '" +
             (folder / "out").string() + "' 2>'" + (folder / "err").string() +
             "' & child=$!; while ! grep -q 'roughness 0.125' '" + (folder / "err").string() +
             "'; do sleep 0.05; done; kill -INT $child; wait $child"},
        std::chrono::minutes(5));
    EXPECT_EQ(run.exit_code, 130);
    EXPECT_NE(bytes_of(folder / "err").find("rows that were measured"), std::string::npos);
    const std::string csv = bytes_of(folder / "out/chart.csv");
    EXPECT_NE(csv.find(",specular,0.05,"), std::string::npos);
    EXPECT_EQ(csv.find(",diffuse,"), std::string::npos);
    EXPECT_NE(bytes_of(folder / "out/chart.html").find("Interrupted"), std::string::npos);
}

TEST(ChartTool, FailsBeforeAnyWorkWhereNothingCanCome) {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    expect_failure(tool, run_tool(tool, {"-o", out}), 2);
    expect_failure(tool, run_tool(tool, {panorama, "nowhere.exr", "-o", out}), 3);
    const std::string square = std::string(SPLITSUM_TEST_DATA) + "/unusable/square.exr";
    expect_failure(tool, run_tool(tool, {panorama, square, "-o", out}), 5);
    write_bytes(folder / "file", "not a folder");
    expect_failure(tool, run_tool(tool, {panorama, "-o", (folder / "file").string()}), 4);
    EXPECT_FALSE(std::filesystem::exists(out));
    EXPECT_EQ(bytes_of(folder / "file"), "not a folder");
}

}  // namespace
}  // namespace splitsum::tests
