// Every shader compiles for the languages it names, and the SPIR-V of every one is valid.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/run_program.h"
#include "support/temporary_folder.h"

namespace splitsum::tests {
namespace {

const std::filesystem::path shaders = SPLITSUM_SHADERS;

std::vector<std::filesystem::path> files_in(const std::string& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(shaders / folder))
        files.push_back(entry.path());
    return files;
}

void expect_success(const std::vector<std::string>& command) {
    const ProgramResult result = run_program(command);
    EXPECT_EQ(result.exit_code, 0) << command.back() << "\n" << result.out << result.err;
}

// A fragment shader that holds all of an include and calls nothing: what does not parse or does not
// type-check fails all the same.
std::string shader_around(const std::string& version, const std::filesystem::path& include) {
    return version + bytes_of(include) + "out vec4 colour;\nvoid main() { colour = vec4(1.0); }\n";
}

TEST(ShaderIncludes, CompileAsGlslAndAsEs) {
    const auto includes = files_in("include");
    ASSERT_GE(includes.size(), 2u);
    const TemporaryFolder folder;
    const std::string versions[] = {"#version 450\n", "#version 300 es\nprecision highp float;\n"};
    for (const auto& include : includes)
        for (const std::string& version : versions) {
            const auto source = folder / "include.frag";
            write_bytes(source, shader_around(version, include));
            SCOPED_TRACE(include.string() + " as " + version);
            expect_success({"glslangValidator", source.string()});
        }
}

TEST(ShaderIncludes, TheTestNoticesAnErrorThatOnlyEsHas) {
    const TemporaryFolder folder;
    const auto include = folder / "include.glsl";
    write_bytes(include, "float whole() { float x = 1; return x; }\n");  // ES does not convert
    const auto source = folder / "include.frag";
    write_bytes(source, shader_around("#version 300 es\nprecision highp float;\n", include));
    EXPECT_NE(run_program({"glslangValidator", source.string()}).exit_code, 0);
}

TEST(RuntimeShaders, CompileToValidSpirV) {
    const auto runtime = files_in("runtime");
    ASSERT_GE(runtime.size(), 1u);
    const TemporaryFolder folder;
    const std::string include = "-I" + (shaders / "include").string();
    for (const auto& shader : runtime) {
        SCOPED_TRACE(shader.string());
        const std::string binary = (folder / "shader.spv").string();
        expect_success({"glslangValidator", "-V", include, "-o", binary, shader.string()});
        expect_success({"spirv-val", "--target-env", "vulkan1.0", binary});
    }
}

}  // namespace
}  // namespace splitsum::tests
