#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "support/run_program.h"

namespace splitsum::tests {

/// The names of all programs in build/bin, from tools/CMakeLists.txt.
inline std::vector<std::string> every_tool() {
    std::istringstream names(SPLITSUM_TOOLS);
    std::vector<std::string> tools;
    for (std::string name; names >> name;) tools.push_back(name);
    return tools;
}

/// Those of `wanted` that exist.
inline std::vector<std::string> tools_among(const std::vector<std::string>& wanted) {
    std::vector<std::string> tools;
    for (const std::string& name : every_tool())
        if (std::ranges::find(wanted, name) != wanted.end()) tools.push_back(name);
    return tools;
}

/// The programs that turn one panorama into files.
inline std::vector<std::string> baking_tools() {
    return tools_among({"splitsum-specular", "splitsum-irradiance", "splitsum-bake"});
}

/// Runs a program of build/bin without progress lines, so that stderr holds messages alone.
inline ProgramResult run_tool(const std::string& tool, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), std::string(SPLITSUM_BIN) + "/" + tool);
    arguments.push_back("--quiet");
    return run_program(arguments);
}

/// A failure as documented: the code, nothing on stdout, one line on stderr that begins with the
/// tool's name.
inline void expect_failure(const std::string& tool, const ProgramResult& run, int exit_code) {
    EXPECT_FALSE(run.timed_out);
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err_lines(), 1u) << run.err;
    EXPECT_EQ(run.err.rfind(tool + ": ", 0), 0u) << run.err;
}

/// Names a test of a parametrised suite after its tool: dashes are not allowed there.
inline std::string test_name(const testing::TestParamInfo<std::string>& tool) {
    std::string name = tool.param;
    std::ranges::replace_if(
        name, [](char letter) { return !std::isalnum(letter); }, '_');
    return name;
}

}  // namespace splitsum::tests
