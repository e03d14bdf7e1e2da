#include "shaders/runtime_picture.h"

#include <gtest/gtest.h>

#include "shaders/noise.h"
#include "shaders/twins.h"
#include "splitsum/base/text.h"

namespace splitsum::tests {
namespace {

constexpr Vec3 eye(0.5F, 1.0F, 4.0F);

}  // namespace

// World positions are 2 clip + (0.3, -0.2), on a plane that leans; view_block goes back.
Mesh::Mesh(uint32_t key) {
    const Vec2 clip[] = {{-1, -1}, {3, -1}, {-1, 3}};
    for (size_t k = 0; k < 3; ++k)
        triangle_[k] = {{2 * clip[k].x + 0.3F, 2 * clip[k].y - 0.2F, 0.4F * clip[k].x},
                        Vec3(0.2F, 0.1F, 0.8F) + random_direction(key + static_cast<uint32_t>(k))};
}

std::vector<float> Mesh::view_block() const {
    return {0.5F, 0, 0, 0, 0, 0.5F, 0, 0, 0, 0, 0, 0, -0.15F, 0.1F, 0, 1, eye.x, eye.y, eye.z, 0};
}

Fragment Mesh::at(size_t pixel) const {
    const double right = (static_cast<double>(pixel % picture_size) + 0.5) / (2 * picture_size);
    const double up = (static_cast<double>(pixel / picture_size) + 0.5) / (2 * picture_size);
    const auto blend = [&](Vec3 Vertex::*member) {
        return (1 - right - up) * Vec3d(triangle_[0].*member) +
               right * Vec3d(triangle_[1].*member) + up * Vec3d(triangle_[2].*member);
    };
    const Vec3d position = blend(&Vertex::position);
    return {position, normalize(blend(&Vertex::normal)), normalize(Vec3d(eye) - position)};
}

void expect_picture(const RuntimeShader& shader, uint32_t key, double limit) {
    const Mesh mesh(key);
    for (const Language language : languages) {
        const std::string folder = language == Language::es300 ? "glsl300es/" : "glsl450/";
        Program program(language, built_shader(folder + "surface.vert"),
                        built_shader(folder + shader.file));
        program.set_block("View", mesh.view_block());
        shader.set_up(program);
        const auto colours = program.draw(Mesh::picture_size, Mesh::picture_size, mesh.triangle());
        const Worst worst = worst_difference(
            colours, [&](size_t pixel) { return answer_of(shader.twin(mesh.at(pixel)), 1); });
        EXPECT_LE(worst.difference, limit) << name_of(language) << ", " << worst.where;
        testing::Test::RecordProperty(cat(language == Language::es300 ? "es300_" : "gl450_", key),
                                      cat(worst.difference));
    }
}

Material random_material(uint32_t key) {
    return {{unit_float(key), unit_float(key + 1), unit_float(key + 2)},
            unit_float(key + 3),
            unit_float(key + 4)};
}

Table noisy_split_sums() {
    Table table = noisy_table(32, 2, 1);
    for (size_t i = 0; i < table.values.size(); i += 2) {
        table.values[i] = 0.1F + 0.8F * table.values[i];
        table.values[i + 1] *= 0.1F;
    }
    return table;
}

}  // namespace splitsum::tests
