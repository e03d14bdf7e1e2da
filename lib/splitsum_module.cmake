# splitsum_module(<name> USES <module>... EXTERNAL <target>...)
#
# A static library splitsum::<name> from lib/splitsum/<name>/*.cpp. Modules without a .cpp file are
# interface libraries. EXTERNAL targets are public because their types may appear in our headers.
function(splitsum_module name)
  cmake_parse_arguments(PARSE_ARGV 1 module "" "" "USES;EXTERNAL")
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/splitsum/${name}/*.cpp)
  list(TRANSFORM module_USES PREPEND splitsum::)
  if(sources)
    add_library(splitsum_${name} STATIC ${sources})
    set(visibility PUBLIC)
  else()
    add_library(splitsum_${name} INTERFACE)
    set(visibility INTERFACE)
  endif()
  add_library(splitsum::${name} ALIAS splitsum_${name})
  target_include_directories(splitsum_${name} ${visibility} ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(splitsum_${name} ${visibility} ${module_USES} ${module_EXTERNAL})
endfunction()
