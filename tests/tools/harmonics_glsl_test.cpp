// The GLSL that splitsum-irradiance writes is a program: here it is compiled, as C++ and by
// glslangValidator, and gives what the coefficients of the .json give. The files are made while the
// tests are built (CMakeLists.txt).
#include <glm/glm.hpp>

#include <array>
#include <cmath>

#include "splitsum/math/harmonics.h"
#include "support/temporary_folder.h"
#include "tools/programs.h"

// GLM's double vectors stand for GLSL's, so that GLSL's literals are of the same kind.
namespace splitsum::tests::glsl {

using vec3 = glm::dvec3;

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"  // order 0 is the same everywhere

namespace order0 {
#include "harmonics/order0.glsl"
}
namespace order1 {
#include "harmonics/order1.glsl"
}
namespace order2 {
#include "harmonics/order2.glsl"
}
namespace order3 {
#include "harmonics/order3.glsl"
}
namespace order4 {
#include "harmonics/order4.glsl"
}
#pragma GCC diagnostic pop

}  // namespace splitsum::tests::glsl

namespace splitsum::tests {
namespace {

constexpr std::array<Vec3d (*)(Vec3d), 5> programs = {
    glsl::order0::splitsum_irradiance, glsl::order1::splitsum_irradiance,
    glsl::order2::splitsum_irradiance, glsl::order3::splitsum_irradiance,
    glsl::order4::splitsum_irradiance};

std::filesystem::path file_of_order(int order, const std::string& ending) {
    return std::string(SPLITSUM_HARMONICS) + "/order" + std::to_string(order) + ending;
}

std::vector<Vec3d> coefficients_of(int order) {
    std::istringstream text(bytes_of(file_of_order(order, ".txt")));
    std::string comment;
    std::getline(text, comment);
    std::vector<Vec3d> coefficients;
    for (Vec3d c; text >> c.x >> c.y >> c.z;) coefficients.push_back(c);
    return coefficients;
}

TEST(HarmonicsGlsl, GivesWhatTheCoefficientsGive) {
    for (int order = 0; order < 5; ++order) {
        const std::vector<Vec3d> coefficients = coefficients_of(order);
        ASSERT_EQ(coefficients.size(), harmonic_count(order));
        std::vector<double> values(coefficients.size());
        for (int i = 0; i < 200; ++i) {
            const double z = 1 - (i + 0.5) / 100, azimuth = 2.399963 * i;
            const double sine = std::sqrt(1 - z * z);
            const Vec3d n(sine * std::cos(azimuth), sine * std::sin(azimuth), z);
            evaluate_harmonics(n, order, values);
            Vec3d expected(0);
            for (size_t k = 0; k < values.size(); ++k) expected += values[k] * coefficients[k];
            // Nine digits are written.
            ASSERT_LT(length(programs[size_t(order)](n) - expected), 1e-7) << order << " " << i;
        }
    }
}

TEST(HarmonicsGlsl, CompilesAsGlslAndAsEs) {
    const TemporaryFolder folder;
    for (int order = 0; order < 5; ++order)
        for (const char* version :
             {"#version 450\n", "#version 300 es\nprecision highp float;\n"}) {
            const auto shader = folder / "harmonics.frag";
            write_bytes(shader,
                        version + bytes_of(file_of_order(order, ".glsl")) +
                            "out vec4 colour;\nvoid main() {\n"
                            "    colour = vec4(splitsum_irradiance(vec3(0.0, 1.0, 0.0)), 1.0);\n"
                            "}\n");
            const auto run = run_program({"glslangValidator", shader.string()});
            EXPECT_EQ(run.exit_code, 0) << order << version << run.out;
        }
}

}  // namespace
}  // namespace splitsum::tests
