// What all programs have in common: --help, --version, and the exit code of a wrong call.
#include "splitsum/base/version.h"
#include "tools/programs.h"

namespace splitsum::tests {
namespace {

class EveryTool : public testing::TestWithParam<std::string> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(EveryTool);
INSTANTIATE_TEST_SUITE_P(Tools, EveryTool, testing::ValuesIn(every_tool()), test_name);

TEST_P(EveryTool, ExplainsItself) {
    const ProgramResult run = run_tool(GetParam(), {"--help"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.err, "");
    for (const char* part : {"Usage: ", "Example", "Exit codes: 0 done", "--threads", "--quiet"})
        EXPECT_NE(run.out.find(part), std::string::npos) << part << " is not in\n" << run.out;
}

TEST_P(EveryTool, TellsItsVersion) {
    const ProgramResult run = run_tool(GetParam(), {"--version"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out, GetParam() + " " + version + "\n");
}

TEST_P(EveryTool, RefusesAnUnknownOptionAndNamesTheNearest) {
    const ProgramResult run = run_tool(GetParam(), {"--theads", "2"});
    expect_failure(GetParam(), run, 2);
    EXPECT_NE(run.err.find("did you mean --threads?"), std::string::npos) << run.err;
}

TEST_P(EveryTool, RefusesToRunWithoutArguments) {
    expect_failure(GetParam(), run_tool(GetParam(), {}), 2);
}

TEST_P(EveryTool, RefusesANumberOfThreadsThatIsNone) {
    for (const char* threads : {"-1", "two", "1.5", "99999999999999999999", ""})
        expect_failure(GetParam(), run_tool(GetParam(), {"--threads", threads}), 2);
}

TEST_P(EveryTool, NoticesThatItsResultsCannotBePrinted) {
    const ProgramResult run = run_program(
        {"/bin/sh", "-c", std::string(SPLITSUM_BIN) + "/" + GetParam() + " --help >/dev/full"});
    EXPECT_EQ(run.exit_code, 4);
    EXPECT_EQ(run.err_lines(), 1u) << run.err;
}

}  // namespace
}  // namespace splitsum::tests
