# The constants of page_files_detail.h from files:
#   cmake -D OUTPUT=<file> -D HTML=<file> -D STYLE=<file> "-DSCRIPT=<file>;..." -D VERTEX_SHADER=<file>
#         -D FRAGMENT_SHADER=<file> -P embed.cmake
cmake_minimum_required(VERSION 3.25)
set(text "#include \"splitsum/preview/page_files_detail.h\"\n\nnamespace splitsum::page_files {\n")
foreach(name HTML STYLE SCRIPT VERTEX_SHADER FRAGMENT_SHADER)
  set(content "")
  foreach(path IN LISTS ${name})
    file(READ ${path} part)
    string(APPEND content "${part}")
  endforeach()
  if(content MATCHES "\\)page_file\"")
    message(FATAL_ERROR "${${name}} holds what ends a raw string: )page_file\"")
  endif()
  string(TOLOWER ${name} constant)
  string(APPEND text "\nconst std::string_view ${constant} = R\"page_file(${content})page_file\";\n")
endforeach()
string(APPEND text "\n}  // namespace splitsum::page_files\n")
file(WRITE ${OUTPUT} "${text}")
