// Every include and every whole shader compiles for the languages it is written for, and every
// translation for which there is a compiler: SPIR-V by spirv-val, HLSL by glslang. Metal has no
// compiler here; WGSL's is in tint/.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "splitsum/base/text.h"
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
    EXPECT_GE(files.size(), 6u);
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

// The names of the functions that an include defines: "<type> splitsum_...(" from a line's start.
std::vector<std::string> functions_of(const std::filesystem::path& include) {
    std::istringstream text(bytes_of(include));
    std::vector<std::string> names;
    for (std::string line; std::getline(text, line);) {
        const size_t name = line.find(' ') + 1, parameters = line.find('(');
        if (line.starts_with("//") || line.compare(name, 9, "splitsum_") != 0) continue;
        if (parameters != std::string::npos && line.find('=') == std::string::npos)
            names.push_back(line.substr(name, parameters - name));
    }
    return names;
}

TEST(Translations, HoldEveryFunctionOfTheLibrary) {
    const std::string hlsl = bytes_of(built / "hlsl/every_function.frag.hlsl");
    const std::string metal = bytes_of(built / "msl/every_function.frag.metal");
    size_t count = 0;
    for (const auto& include : files_in(built / "include"))
        for (const std::string& function : functions_of(include)) {
            ++count;
            EXPECT_NE(hlsl.find(cat(" ", function, "(")), std::string::npos) << function;
            EXPECT_NE(metal.find(cat(" ", function, "(")), std::string::npos) << function;
        }
    EXPECT_GT(count, 45u);
}

TEST(RuntimeShaders, AreWrittenAsMetal) {
    for (const auto& shader : translations("msl", ".metal"))
        EXPECT_NE(bytes_of(shader).find("main0("), std::string::npos) << shader;
}

}  // namespace
}  // namespace splitsum::tests
