#include "shaders/program.h"

#include <GLES3/gl3.h>

#include <stdexcept>

namespace splitsum::tests {
namespace {

GLuint compiled(GLenum stage, const std::string& source) {
    const GLuint shader = glCreateShader(stage);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint success = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &success);
    if (success == GL_TRUE) return shader;
    std::string log(4096, '\0');
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error(log.c_str() + ("\n" + source));
}

GLuint linked(const std::string& vertex_source, const std::string& fragment_source) {
    const GLuint program = glCreateProgram();
    const GLuint vertex = compiled(GL_VERTEX_SHADER, vertex_source);
    const GLuint fragment = compiled(GL_FRAGMENT_SHADER, fragment_source);
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint success = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &success);
    if (success == GL_TRUE) return program;
    std::string log(4096, '\0');
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error(log.c_str());
}

void set_filter(GLenum target, GLint minify, GLint magnify) {
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, minify);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, magnify);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

struct Channels {
    GLint stored;
    GLenum given;
};

Channels channels_of(const Table& table) {
    if (table.channels == 1) return {GL_R32F, GL_RED};
    if (table.channels == 2) return {GL_RG32F, GL_RG};
    if (table.channels == 4) return {GL_RGBA32F, GL_RGBA};
    throw std::runtime_error("tables have 1, 2 or 4 channels");
}

void check_driver(const std::string& where) {
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR)
        throw std::runtime_error(where + ": GL error " + std::to_string(error));
}

// What a picture is drawn into: four floats a pixel.
class Picture {
public:
    Picture(int width, int height) : width_(width), height_(height) {
        glGenFramebuffers(1, &framebuffer_);
        glGenRenderbuffers(1, &colours_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glBindRenderbuffer(GL_RENDERBUFFER, colours_);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours_);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw std::runtime_error("the driver draws no floats");
        glViewport(0, 0, width, height);
    }
    ~Picture() {
        glDeleteRenderbuffers(1, &colours_);
        glDeleteFramebuffers(1, &framebuffer_);
    }
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;

    std::vector<Float4> colours() const {
        std::vector<Float4> read(static_cast<size_t>(width_) * static_cast<size_t>(height_));
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, read.data());
        return read;
    }

private:
    int width_, height_;
    GLuint framebuffer_ = 0, colours_ = 0;
};

}  // namespace

Program::Program(Language language, const std::string& vertex_source,
                 const std::string& fragment_source)
    : language_(language) {
    use_context(language);
    program_ = linked(vertex_source, fragment_source);
}

Program::~Program() {
    use_context(language_);
    glDeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
    glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    glDeleteProgram(program_);
}

uint32_t Program::new_texture(const std::string& sampler, uint32_t target) {
    use_context(language_);
    const auto unit = static_cast<GLint>(textures_.size());
    GLuint texture = 0;
    glGenTextures(1, &texture);
    textures_.push_back(texture);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(target, texture);
    glUseProgram(program_);
    glUniform1i(glGetUniformLocation(program_, sampler.c_str()), unit);
    return texture;
}

void Program::set_cubemap(const std::string& sampler, std::span<const Cubemap> levels) {
    new_texture(sampler, GL_TEXTURE_CUBE_MAP);
    for (size_t level = 0; level < levels.size(); ++level)
        for (int face = 0; face < face_count; ++face)
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face),
                         static_cast<GLint>(level), GL_RGB32F, levels[level].face_size,
                         levels[level].face_size, 0, GL_RGB, GL_FLOAT,
                         &levels[level].at(face, 0, 0));
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL,
                    static_cast<GLint>(levels.size()) - 1);
    set_filter(GL_TEXTURE_CUBE_MAP, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    check_driver(sampler);
}

void Program::set_table(const std::string& sampler, const Table& table) {
    const Channels channels = channels_of(table);
    const GLenum target = table.layers > 1 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
    new_texture(sampler, target);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    if (table.layers > 1)
        glTexImage3D(target, 0, channels.stored, table.width, table.height, table.layers, 0,
                     channels.given, GL_FLOAT, table.values.data());
    else
        glTexImage2D(target, 0, channels.stored, table.width, table.height, 0, channels.given,
                     GL_FLOAT, table.values.data());
    set_filter(target, GL_LINEAR, GL_LINEAR);
    check_driver(sampler);
}

void Program::set_texels(const std::string& sampler, int width, std::span<const Float4> texels) {
    new_texture(sampler, GL_TEXTURE_2D);
    const auto height = static_cast<GLsizei>(texels.size()) / width;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, texels.data());
    set_filter(GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
    check_driver(sampler);
}

void Program::set_block(const std::string& block, std::span<const float> values) {
    use_context(language_);
    const GLuint index = glGetUniformBlockIndex(program_, block.c_str());
    if (index == GL_INVALID_INDEX) throw std::runtime_error("no uniform block " + block);
    GLint wanted = 0;
    glGetActiveUniformBlockiv(program_, index, GL_UNIFORM_BLOCK_DATA_SIZE, &wanted);
    if (static_cast<size_t>(wanted) > values.size_bytes())
        throw std::runtime_error(block + " has " + std::to_string(wanted) + " bytes");
    const auto unit = static_cast<GLuint>(buffers_.size());
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    buffers_.push_back(buffer);
    glBindBufferBase(GL_UNIFORM_BUFFER, unit, buffer);
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(values.size_bytes()), values.data(),
                 GL_STATIC_DRAW);
    glUniformBlockBinding(program_, index, unit);
    check_driver(block);
}

std::vector<Float4> Program::draw(int width, int height, const std::array<Vertex, 3>& triangle) {
    use_context(language_);
    const Picture picture(width, height);
    GLuint array = 0, buffer = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    buffers_.push_back(buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof triangle, triangle.data(), GL_STATIC_DRAW);
    for (const GLuint attribute : {0U, 1U}) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                              reinterpret_cast<const void*>(attribute * sizeof(Vec3)));
    }
    glUseProgram(program_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    auto colours = picture.colours();
    glDeleteVertexArrays(1, &array);
    check_driver("drawing");
    return colours;
}

}  // namespace splitsum::tests
