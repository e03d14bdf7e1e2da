#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "shaders/program.h"
#include "splitsum/shading/surface.h"

namespace splitsum::tests {

/// What a fragment shader of shaders/runtime gets at a pixel.
struct Fragment {
    Vec3d position;
    Vec3d normal;
    Vec3d view;

    Vec3d reflection() const { return 2 * dot(normal, view) * normal - view; }
};

/// A triangle in space that covers the picture, with normals far apart: reflections go everywhere.
class Mesh {
public:
    static constexpr int picture_size = 64;

    explicit Mesh(uint32_t key);
    Fragment at(size_t pixel) const;
    const std::array<Vertex, 3>& triangle() const { return triangle_; }
    std::vector<float> view_block() const;

private:
    std::array<Vertex, 3> triangle_;
};

/// One shader of shaders/runtime: its file, what it reads, and what the library says to a pixel.
struct RuntimeShader {
    std::string file;
    std::function<void(Program&)> set_up;
    std::function<Vec3d(const Fragment&)> twin;
};

/// Draws the mesh of `key` in both languages and compares every pixel with the twin.
void expect_picture(const RuntimeShader& shader, uint32_t key, double limit);

/// The keys of the pictures that each test draws.
inline constexpr uint32_t picture_keys[] = {0, 10, 20, 30, 40, 50};

struct Material {
    Vec3 base_color;
    float metalness;
    float perceptual_roughness;

    double r() const { return static_cast<double>(perceptual_roughness); }
    SurfaceResponse response(const SplitSum& sum) const {
        return response_of(Vec3d(base_color), static_cast<double>(metalness), sum);
    }
};

Material random_material(uint32_t key);

/// Texels of a split sum that no surface has: a in [0.1, 0.9), b in [0, 0.1), nothing smooth.
Table noisy_split_sums();

}  // namespace splitsum::tests
