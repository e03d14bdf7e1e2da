#pragma once

#include <string_view>

namespace splitsum::tests {

/// The languages that every shader has to work in.
enum class Language { glsl450, es300 };

inline constexpr Language languages[] = {Language::glsl450, Language::es300};

std::string_view name_of(Language language);

/// Makes an OpenGL 4.5 core or an OpenGL ES 3.0 context current, on Mesa's software driver, without a
/// display. Each is made once and lives until the program ends. Throws std::runtime_error with
/// EGL's reason where there is no such driver: a machine that cannot run shaders fails their tests.
void use_context(Language language);

}  // namespace splitsum::tests
