#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "shaders/gl_context.h"
#include "splitsum/image/table.h"
#include "splitsum/math/vec.h"
#include "splitsum/sphere/cubemap.h"

namespace splitsum::tests {

using Float4 = std::array<float, 4>;

/// What a vertex of the one triangle that covers the picture brings along.
struct Vertex {
    Vec3 position;
    Vec3 normal;
};

/// A pair of shaders on the software driver, with what they read. Sources are whole, #version
/// included. Everything throws std::runtime_error with the driver's words.
class Program {
public:
    Program(Language language, const std::string& vertex_source,
            const std::string& fragment_source);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// Textures of floats with a linear filter (levels too), clamped to the edge. A sampler that the
    /// shader does not use is no error.
    void set_cubemap(const std::string& sampler, std::span<const Cubemap> levels);
    void set_table(const std::string& sampler, const Table& table);

    /// A texture that texelFetch reads, row by row.
    void set_texels(const std::string& sampler, int width, std::span<const Float4> texels);

    /// A uniform block in std140's layout, floats and integers four bytes each.
    void set_block(const std::string& block, std::span<const float> values);

    /// The colours, row 0 (y = 0.5) first, of a triangle whose attributes 0 and 1 are the vertices'.
    std::vector<Float4> draw(int width, int height, const std::array<Vertex, 3>& triangle);

private:
    uint32_t new_texture(const std::string& sampler, uint32_t target);

    Language language_;
    uint32_t program_ = 0;
    std::vector<uint32_t> textures_;
    std::vector<uint32_t> buffers_;
};

}  // namespace splitsum::tests
