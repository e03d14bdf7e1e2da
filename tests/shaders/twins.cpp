#include "shaders/twins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/text.h"
#include "support/temporary_folder.h"

namespace splitsum::tests {
namespace {

constexpr int picture_width = 64;

constexpr const char* vertex_shader = R"(
layout(location = 0) in vec3 position;
void main() { gl_Position = vec4(position, 1.0); }
)";

std::string header_of(Language language) {
    return cat("#version ", language == Language::es300 ? "300 es" : "450",
               "\nprecision highp float;\nprecision highp int;\n");
}

std::string fragment_shader(Language language, const Question& question, int rows) {
    std::string text = header_of(language);
    for (const std::string& include : question.includes)
        text += built_shader(cat("include/splitsum_", include, ".glsl"));
    return cat(text, "uniform highp sampler2D inputs;\nlayout(location = 0) out vec4 answer;\n",
               "vec4 asked(int k) {\n    return texelFetch(inputs, ivec2(int(gl_FragCoord.x), ",
               "int(gl_FragCoord.y) + k * ", rows, "), 0);\n}\n", question.declarations,
               "\nvoid main() {\n    answer = vec4(0.0);\n", question.body, "\n}\n");
}

// Input after input, each filled up to whole rows.
std::vector<Float4> in_rows(const std::vector<std::vector<Float4>>& inputs, int rows) {
    const auto padded = static_cast<size_t>(picture_width) * static_cast<size_t>(rows);
    std::vector<Float4> texels;
    for (const auto& input : inputs) {
        texels.insert(texels.end(), input.begin(), input.end());
        texels.insert(texels.end(), padded - input.size(), input.back());
    }
    return texels;
}

// Covers the whole picture.
constexpr std::array<Vertex, 3> everything = {
    {{Vec3(-1, -1, 0), Vec3(0)}, {Vec3(3, -1, 0), Vec3(0)}, {Vec3(-1, 3, 0), Vec3(0)}}};

}  // namespace

std::string built_shader(const std::string& path) {
    const std::string text = bytes_of(cat(SPLITSUM_BUILT_SHADERS, "/", path));
    if (text.empty()) throw std::runtime_error("no shader " + path);
    return text;
}

Vec3 random_direction(uint32_t key) {
    const float z = between(-1, 1, 2 * key);
    const float azimuth = between(0, 2 * std::numbers::pi_v<float>, 2 * key + 1);
    const float across = std::sqrt(1 - z * z);
    return {across * std::cos(azimuth), across * std::sin(azimuth), z};
}

std::vector<Float4> answers_of_shader(Language language, const Question& question) {
    const size_t count = question.inputs.front().size();
    const int rows = (static_cast<int>(count) + picture_width - 1) / picture_width;
    Program program(language, header_of(language) + vertex_shader,
                    fragment_shader(language, question, rows));
    program.set_texels("inputs", picture_width, in_rows(question.inputs, rows));
    if (question.set_up) question.set_up(program);
    std::vector<Float4> answers = program.draw(picture_width, rows, everything);
    answers.resize(count);
    return answers;
}

Worst worst_difference(const std::vector<Float4>& found,
                       const std::function<Answer(size_t)>& twin) {
    Worst worst;
    for (size_t i = 0; i < found.size(); ++i) {
        const Answer expected = twin(i);
        for (size_t k = 0; k < expected.size(); ++k) {
            const double shader = static_cast<double>(found[i][k]);
            const double difference =
                std::abs(shader - expected[k]) / std::max(1.0, std::abs(expected[k]));
            if (difference <= worst.difference) continue;  // so that NaN counts
            worst = {difference,
                     cat("item ", i, ", number ", k, ": shader ", shader, ", twin ", expected[k])};
            if (std::isnan(difference)) return worst;
        }
    }
    return worst;
}

void expect_twin(const Question& question, double limit,
                 const std::function<Answer(size_t item)>& twin) {
    ASSERT_GE(question.inputs.front().size(), 1000u) << "thousands of inputs make a comparison";
    for (const Language language : languages) {
        const Worst worst = worst_difference(answers_of_shader(language, question), twin);
        EXPECT_LE(worst.difference, limit) << name_of(language) << ", " << worst.where;
        testing::Test::RecordProperty(language == Language::es300 ? "es300" : "glsl450",
                                      cat(worst.difference));
    }
}

}  // namespace splitsum::tests
