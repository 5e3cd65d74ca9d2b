# What a program was built from. build_information.hpp is written at every build, changed only when it differs; so is
# worker_build.json, which says the same of phytobench_worker: in its code a commit would make two builds of equal
# sources two programs. build_flags.hpp holds what does not change from commit to commit.
set(PHYTOBENCH_COMPILE_FLAGS "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE}")
if(NOT CMAKE_BUILD_TYPE STREQUAL "Release")
  set(PHYTOBENCH_COMPILE_FLAGS "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_DEBUG}")
endif()
get_directory_property(options COMPILE_OPTIONS)
# Where the sources lie is no property of the program.
list(FILTER options EXCLUDE REGEX "^-ffile-prefix-map=")
string(REPLACE ";" " " options "${options}")
string(STRIP "${PHYTOBENCH_COMPILE_FLAGS} ${options}" PHYTOBENCH_COMPILE_FLAGS)

set(COMPILER "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
set(FLAGS "${PHYTOBENCH_COMPILE_FLAGS}")
configure_file(${PROJECT_SOURCE_DIR}/cmake/build_flags.hpp.in ${CMAKE_BINARY_DIR}/generated/build_flags.hpp @ONLY)

add_custom_target(build_information_file
  COMMAND ${CMAKE_COMMAND}
    -D GENERATED=${CMAKE_BINARY_DIR}/generated
    -D BINARY=${CMAKE_BINARY_DIR}
    -D TEMPLATES=${PROJECT_SOURCE_DIR}/cmake
    -D SOURCE=${PROJECT_SOURCE_DIR}
    -D GIVEN_COMMIT=${PHYTOBENCH_COMMIT}
    -D VERSION=${PROJECT_VERSION}
    -D BUILD_TYPE=${CMAKE_BUILD_TYPE}
    -D "COMPILER=${COMPILER}"
    -D "FLAGS=${FLAGS}"
    -P ${PROJECT_SOURCE_DIR}/cmake/write_build_information.cmake
  BYPRODUCTS ${CMAKE_BINARY_DIR}/generated/build_information.hpp ${CMAKE_BINARY_DIR}/worker_build.json
  VERBATIM)
add_library(build_information INTERFACE)
target_include_directories(build_information INTERFACE ${CMAKE_BINARY_DIR}/generated)
add_dependencies(build_information build_information_file)
