// Every include and every whole shader compiles for the languages it is written for, and every
// translation for which there is a compiler: SPIR-V by spirv-val, HLSL by glslang. Metal has no
// compiler here; WGSL's is in tint/.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/run_program.h"
#include "support/temporary_folder.h"

namespace splitsum::tests {
namespace {

const std::filesystem::path built = SPLITSUM_BUILT_SHADERS;
const std::filesystem::path sources = SPLITSUM_SHADERS;

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
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
    const auto includes = files_in(built / "include");
    ASSERT_EQ(includes.size(), files_in(sources / "include").size() + 1) << "and the closed form";
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

// All shaders of shaders/runtime, whose files in build/shaders/<folder> end in `ending`.
std::vector<std::filesystem::path> translations(const std::string& folder,
                                                const std::string& ending) {
    std::vector<std::filesystem::path> files;
    for (const auto& shader : files_in(sources / "runtime"))
        if (shader.extension() != ".glsl")
            files.push_back(built / folder / (shader.filename().string() + ending));
    EXPECT_GE(files.size(), 5u);
    for (const auto& file : files) EXPECT_FALSE(bytes_of(file).empty()) << file;
    return files;
}

TEST(RuntimeShaders, CompileWholeAsGlslAndAsEs) {
    for (const char* folder : {"glsl450", "glsl300es"})
        for (const auto& shader : translations(folder, ""))
            expect_success({"glslangValidator", shader.string()});
}

TEST(RuntimeShaders, AreValidSpirV) {
    for (const auto& binary : translations("spirv", ".spv"))
        expect_success({"spirv-val", "--target-env", "vulkan1.0", binary.string()});
}

TEST(RuntimeShaders, AreHlslThatGlslangReads) {
    const TemporaryFolder folder;
    const std::string binary = (folder / "shader.spv").string();
    for (const auto& shader : translations("hlsl", ".hlsl")) {
        const std::string stage = shader.stem().extension().string().substr(1);
        expect_success({"glslangValidator", "-D", "-V", "-S", stage, "-e", "main", "-o", binary,
                        shader.string()});
        expect_success({"spirv-val", "--target-env", "vulkan1.0", binary});
    }
}

TEST(RuntimeShaders, AreWrittenAsMetal) {
    for (const auto& shader : translations("msl", ".metal"))
        EXPECT_NE(bytes_of(shader).find("main0("), std::string::npos) << shader;
}

}  // namespace
}  // namespace splitsum::tests
