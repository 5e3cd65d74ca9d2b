include(GoogleTest)

# One test program per layer from every *_test.cpp below the folder. The suite's name gives the label: *Law,
# *Oracle, *Slow, *Tidy; all others are unit tests. WITHOUT names what a missing library leaves out.
function(phytobench_tests NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES;WITHOUT" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *_test.cpp)
  foreach(pattern IN LISTS ARG_WITHOUT)
    list(FILTER sources EXCLUDE REGEX "${pattern}")
  endforeach()
  if(NOT sources)
    message(FATAL_ERROR "${NAME}: no *_test.cpp in ${CMAKE_CURRENT_SOURCE_DIR}")
  endif()
  add_executable(${NAME} ${sources} ${ARG_SOURCES})
  # GoogleTest's macros hold an if of their own.
  target_compile_options(${NAME} PRIVATE -Wno-dangling-else)
  target_link_libraries(${NAME} PRIVATE ${ARG_LIBRARIES} GTest::gtest_main GTest::gmock)
  set(environment "PHYTOBENCH_DATA=${CMAKE_BINARY_DIR}/share")
  foreach(label law oracle slow tidy)
    string(SUBSTRING ${label} 0 1 first)
    string(TOUPPER ${first} first)
    string(SUBSTRING ${label} 1 -1 rest)
    set(filter "*${first}${rest}.*:*${first}${rest}/*")
    gtest_discover_tests(${NAME} TEST_FILTER ${filter} TEST_LIST ${NAME}_${label} DISCOVERY_MODE PRE_TEST
                         PROPERTIES LABELS ${label} ENVIRONMENT ${environment} TIMEOUT 600)
    list(APPEND special ${filter})
  endforeach()
  string(REPLACE ";" ":" special "${special}")
  gtest_discover_tests(${NAME} TEST_FILTER "-${special}" TEST_LIST ${NAME}_unit DISCOVERY_MODE PRE_TEST
                       PROPERTIES LABELS unit ENVIRONMENT ${environment} TIMEOUT 600)
endfunction()
