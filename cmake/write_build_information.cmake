# GIVEN_COMMIT is what a source tree without a repository was taken from.
set(COMMIT "unknown")
set(SOURCE_CHANGED "false")
find_program(GIT git)
if(GIVEN_COMMIT)
  set(COMMIT "${GIVEN_COMMIT}")
elseif(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --short=12 HEAD
                  OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(COMMIT "${found}")
  endif()
  # Of what is compiled or read by programs; notes beside it change nothing.
  execute_process(COMMAND ${GIT} -C ${SOURCE} status --porcelain --
                          core reference benchmarks experiments reports cli cmake examples CMakeLists.txt CMakePresets.json
                  OUTPUT_VARIABLE changes ERROR_QUIET)
  if(changes)
    set(SOURCE_CHANGED "true")
  endif()
endif()
configure_file(${TEMPLATES}/build_information.hpp.in ${GENERATED}/build_information.hpp @ONLY)
configure_file(${TEMPLATES}/worker_build.json.in ${BINARY}/worker_build.json @ONLY)
