#include "shaders/gl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace splitsum::tests {
namespace {

constexpr GLenum seamless_cubemaps = 0x884F;  // GL_TEXTURE_CUBE_MAP_SEAMLESS; ES 3 always does it

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error(what + " failed, EGL error " + std::to_string(eglGetError()) +
                             "; the Debian packages libegl1 and libgl1-mesa-dri are needed");
}

EGLDisplay open_display() {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);  // it would lie in the home folder
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
        fail("opening EGL's surfaceless platform");
    return display;
}

EGLContext open_context(EGLDisplay display, Language language) {
    const bool es = language == Language::es300;
    const EGLint version_es[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0,
                                 EGL_NONE};
    const EGLint version_gl[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    if (!eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API)) fail("choosing the language");
    const EGLContext context =
        eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, es ? version_es : version_gl);
    if (context == EGL_NO_CONTEXT) fail("making a context");
    return context;
}

}  // namespace

std::string_view name_of(Language language) {
    return language == Language::es300 ? "ES 3.00" : "GLSL 4.50";
}

void use_context(Language language) {
    static const EGLDisplay display = open_display();
    static const EGLContext gl = open_context(display, Language::glsl450);
    static const EGLContext es = open_context(display, Language::es300);
    const bool is_es = language == Language::es300;
    eglBindAPI(is_es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, is_es ? es : gl))
        fail("using a context");
    if (!is_es) glEnable(seamless_cubemaps);
}

}  // namespace splitsum::tests
