# Every third-party package that the library and the tools link, all packaged by Debian 12 and permissively licensed.
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(glm REQUIRED)
# Debian 12's Imath also describes its Python binding, which it packages apart, and says at length
# that it is not there; nothing here needs it.
set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
find_package(Imath REQUIRED)
unset(CMAKE_MESSAGE_LOG_LEVEL)
find_package(OpenEXR REQUIRED)
find_package(OpenImageIO REQUIRED)
# Debian 12 files this package under share/cmake itself, where CMake looks only when told.
find_package(OpenColorIO REQUIRED HINTS /usr/share/cmake)
find_package(nlohmann_json REQUIRED)
find_package(PNG REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(zstd REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(hwy REQUIRED IMPORTED_TARGET libhwy)
pkg_check_modules(kissfft REQUIRED IMPORTED_TARGET kissfft-float)
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus)
pkg_check_modules(jsoncpp REQUIRED IMPORTED_TARGET jsoncpp)
add_library(kissfft ALIAS PkgConfig::kissfft)
add_library(zstd ALIAS PkgConfig::zstd)
add_library(xxhash ALIAS PkgConfig::xxhash)
add_library(hwy::hwy ALIAS PkgConfig::hwy)
add_library(tomlplusplus ALIAS PkgConfig::tomlplusplus)
add_library(jsoncpp ALIAS PkgConfig::jsoncpp)

# Debian 12's OpenImageIO names /usr/include/opencv4, which only libopencv-dev provides; CMake
# refuses a missing include directory.
get_target_property(oiio_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
list(FILTER oiio_includes EXCLUDE REGEX opencv)
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
                      INTERFACE_INCLUDE_DIRECTORIES "${oiio_includes}")

# Debian 12's OpenColorIO computes its prefix as if it were under lib/cmake/OpenColorIO, and so
# names /include; its headers are in the compiler's own search path.
set_target_properties(OpenColorIO::OpenColorIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "")
