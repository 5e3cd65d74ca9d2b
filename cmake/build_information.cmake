# build_information.hpp says what a program was built from. Written at every build, changed only when it differs.
set(PHYTOBENCH_COMPILE_FLAGS "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE}")
if(NOT CMAKE_BUILD_TYPE STREQUAL "Release")
  set(PHYTOBENCH_COMPILE_FLAGS "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_DEBUG}")
endif()
get_directory_property(options COMPILE_OPTIONS)
string(REPLACE ";" " " options "${options}")
string(STRIP "${PHYTOBENCH_COMPILE_FLAGS} ${options}" PHYTOBENCH_COMPILE_FLAGS)

add_custom_target(build_information_file
  COMMAND ${CMAKE_COMMAND}
    -D OUTPUT=${CMAKE_BINARY_DIR}/generated/build_information.hpp
    -D TEMPLATE=${PROJECT_SOURCE_DIR}/cmake/build_information.hpp.in
    -D SOURCE=${PROJECT_SOURCE_DIR}
    -D VERSION=${PROJECT_VERSION}
    -D BUILD_TYPE=${CMAKE_BUILD_TYPE}
    -D "COMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
    -D "FLAGS=${PHYTOBENCH_COMPILE_FLAGS}"
    -P ${PROJECT_SOURCE_DIR}/cmake/write_build_information.cmake
  BYPRODUCTS ${CMAKE_BINARY_DIR}/generated/build_information.hpp
  VERBATIM)
add_library(build_information INTERFACE)
target_include_directories(build_information INTERFACE ${CMAKE_BINARY_DIR}/generated)
add_dependencies(build_information build_information_file)
