#pragma once

#include <string_view>

namespace splitsum::page_files {

// The files of page/ as they were when the library was built (page/CMakeLists.txt).

extern const std::string_view html;             ///< with {{places}} that page.cpp fills
extern const std::string_view style;            ///< CSS
extern const std::string_view script;           ///< a JavaScript module
extern const std::string_view vertex_shader;    ///< GLSL ES 3.00, without #include
extern const std::string_view fragment_shader;  ///< GLSL ES 3.00, without #include

}  // namespace splitsum::page_files
