# splitsum_bake(<target> [ALL] [PANORAMAS] <file or folder>... | MANIFEST <file>
#               [OUTPUT <folder>] [OPTIONS <option>...])
#
# A target that bakes panoramas whenever one of them, an option, a manifest or splitsum-bake itself has
# changed; it redoes only what the change concerns. README.md has examples.
#
# PANORAMAS  files, and folders that are searched whenever something was added to them or removed;
#            relative to the current source folder. The word itself may be left out.
# MANIFEST   in the place of panoramas: a list of them with settings, for splitsum-bake --manifest
# OUTPUT     where the results go, relative to the current binary folder; <target> unless told
#            otherwise. The target's property SPLITSUM_OUTPUT holds the whole path.
# OPTIONS    options of splitsum-bake, such as --size 512
# ALL        part of the default build
function(splitsum_bake target)
  cmake_parse_arguments(PARSE_ARGV 1 bake "ALL" "MANIFEST;OUTPUT" "PANORAMAS;OPTIONS")
  set(panoramas ${bake_UNPARSED_ARGUMENTS} ${bake_PANORAMAS})
  if(NOT panoramas AND NOT bake_MANIFEST)
    message(FATAL_ERROR "splitsum_bake(${target}): nothing to bake; name panoramas, folders or a MANIFEST")
  endif()
  if(panoramas AND bake_MANIFEST)
    message(FATAL_ERROR "splitsum_bake(${target}): either panoramas or a MANIFEST, which names its own")
  endif()
  if(NOT bake_OUTPUT)
    set(bake_OUTPUT ${target})
  endif()
  cmake_path(ABSOLUTE_PATH bake_OUTPUT BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE)

  set(inputs)
  set(files)
  foreach(panorama IN LISTS panoramas)
    cmake_path(ABSOLUTE_PATH panorama BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    list(APPEND inputs ${panorama})
    if(NOT IS_DIRECTORY ${panorama})
      list(APPEND files ${panorama})
    endif()
  endforeach()
  if(bake_MANIFEST)
    cmake_path(ABSOLUTE_PATH bake_MANIFEST BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    set(manifest --manifest ${bake_MANIFEST})
  endif()

  set(all)
  if(bake_ALL)
    set(all ALL)
  endif()
  set(bake splitsum::splitsum-bake ${inputs} ${manifest} -o ${bake_OUTPUT} ${bake_OPTIONS} --quiet)
  splitsum_bake_byproducts(byproducts "${files}" ${bake_OUTPUT})
  if(CMAKE_GENERATOR MATCHES "Ninja")
    # The stamp says when the library was complete: results that were up to date keep their times.
    set(notes ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.splitsum)
    file(MAKE_DIRECTORY ${notes})
    add_custom_command(
        OUTPUT ${notes}/stamp
        BYPRODUCTS ${byproducts}
        COMMAND ${bake} --depfile ${notes}/depfile --depfile-target ${notes}/stamp
        COMMAND ${CMAKE_COMMAND} -E touch ${notes}/stamp
        DEPENDS ${files} ${bake_MANIFEST} $<TARGET_FILE:splitsum::splitsum-bake>
        DEPFILE ${notes}/depfile
        COMMENT "Baking ${target}" VERBATIM)
    add_custom_target(${target} ${all} DEPENDS ${notes}/stamp)
  else()
    # CMake never takes what a depfile has named out of a makefile again, so that a panorama that is
    # gone would run the command for ever. The program finds what is to do in a moment by itself.
    add_custom_target(${target} ${all} COMMAND ${bake} BYPRODUCTS ${byproducts}
                      COMMENT "Baking what has changed of ${target}" VERBATIM)
  endif()
  set_target_properties(${target} PROPERTIES SPLITSUM_OUTPUT ${bake_OUTPUT})
endfunction()

# splitsum_bake_byproducts(<variable> <files> <output folder>): the assets of panoramas that are named
# one by one, for rules that read them; those of folders and manifests are not known yet.
function(splitsum_bake_byproducts variable files output)
  set(byproducts ${output}/brdf.ktx2)
  foreach(file IN LISTS files)
    cmake_path(GET file STEM LAST_ONLY name)
    foreach(asset specular.ktx2 irradiance.ktx2 harmonics.json report.json)
      list(APPEND byproducts ${output}/${name}/${asset})
    endforeach()
  endforeach()
  set(${variable} ${byproducts} PARENT_SCOPE)
endfunction()
