include(GoogleTest)

# One test program per layer from every *_test.cpp below the folder. The suite's name gives the label: *Law,
# *Oracle, *Slow, *Tidy; all others are unit tests. WITHOUT names what a missing library leaves out. With sanitizers
# a process takes longer to start than most tests take: there every program runs in a few parts, without *Slow and
# *Tidy, and its parts are what is counted.
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
  phytobench_quick_to_compile(${NAME})
  phytobench_in_batches(${NAME})
  set(environment "PHYTOBENCH_DATA=${CMAKE_BINARY_DIR}/share")
  if(PHYTOBENCH_SANITIZERS)
    set(parts 4)
    foreach(part RANGE 1 ${parts})
      math(EXPR index "${part} - 1")
      add_test(NAME ${NAME}_${part}_of_${parts}
               COMMAND ${NAME} --gtest_brief=1 "--gtest_filter=-*Slow.*:*Slow/*:*Tidy.*:*Tidy/*")
      set_tests_properties(${NAME}_${part}_of_${parts} PROPERTIES LABELS unit TIMEOUT 1200
        ENVIRONMENT "${environment};GTEST_TOTAL_SHARDS=${parts};GTEST_SHARD_INDEX=${index}")
    endforeach()
    return()
  endif()
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
