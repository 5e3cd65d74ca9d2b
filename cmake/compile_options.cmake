# Flags of all our code. No contraction to FMA: every target must round alike. Options structs are filled with
# designated initialisers that name only what departs from the defaults, which -Wextra would complain about.
add_compile_options(-Wall -Wextra -Wconversion -Wsign-conversion -Wshadow -Werror -Wno-missing-field-initializers -ffp-contract=off -fno-math-errno)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # GCC 12 sees overlapping copies in plain string concatenation where there are none.
  add_compile_options(-Wno-restrict)
else()
  # Clang does not know every warning that a pragma of ours names.
  add_compile_options(-Wno-unknown-warning-option)
endif()
# Messages of contracts name files from the project's root, wherever it lies: the same sources are the same program.
# (ccache hands the compiler relative paths.)
file(RELATIVE_PATH up ${CMAKE_BINARY_DIR} ${PROJECT_SOURCE_DIR})
cmake_path(APPEND up "")
add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}/= -ffile-prefix-map=${up}=)
if(PHYTOBENCH_ARCHITECTURE)
  add_compile_options(-march=${PHYTOBENCH_ARCHITECTURE})
endif()
if(PHYTOBENCH_SANITIZERS)
  # The instrumentation makes GCC see uninitialised values where there are none (std::function in std::regex).
  add_compile_options(-Wno-maybe-uninitialized -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
# For what computes little, where sanitizers run: without optimisation, and without the checks of every single access
# that the address sanitizer makes, too, it compiles three times as fast.
function(phytobench_quick_to_compile TARGET)
  if(PHYTOBENCH_SANITIZERS)
    target_compile_options(${TARGET} PRIVATE -O0 -fno-sanitize=null,alignment,object-size,vptr)
  endif()
endfunction()
# Most of the time of a full build goes into reading the same headers again. Where no time is measured and nothing is
# registered by a .def line, the files of one folder are compiled together, most_in_batch at once: names without
# linkage are unique within a folder. Sanitizers run over everything compiled so. -DPHYTOBENCH_BATCHES=OFF compiles
# every file alone (a file that misses an include is found there).
option(PHYTOBENCH_BATCHES "Compile the files of one folder together, where nothing is timed" ON)
function(phytobench_in_batches TARGET)
  if(NOT PHYTOBENCH_BATCHES)
    return()
  endif()
  set(most_in_batch 8)
  get_target_property(sources ${TARGET} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(SORT sources)
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    # Headers that are included several times over, with other meanings of their macros; registries that a test compiles
    # again with a longer list (in a batch, the linker would bring in both).
    file(STRINGS ${source} alone REGEX "foreach_target\\.h|_IMPLEMENTATION|#ifndef PHYTOBENCH_" LIMIT_COUNT 1)
    if(alone)
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
      continue()
    endif()
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    if(NOT DEFINED files_of_${folder})
      set(files_of_${folder} 0)
    endif()
    math(EXPR batch "${files_of_${folder}} / ${most_in_batch} + 1")
    math(EXPR files_of_${folder} "${files_of_${folder}} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${batch})
  endforeach()
  set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # A local name may be that of a constant in another file.
    target_compile_options(${TARGET} PRIVATE -Wno-shadow -Wshadow=local)
  endif()
endfunction()
# Whether work is counted stands in a header, not on every command line: what does not include it need not be compiled
# again for the preset `counters` where ccache knows it.
set(COUNTS_WORK 0)
if(PHYTOBENCH_COUNTERS)
  set(COUNTS_WORK 1)
endif()
configure_file(${PROJECT_SOURCE_DIR}/cmake/counting_policy.hpp.in ${CMAKE_BINARY_DIR}/generated/policy/counting_policy.hpp @ONLY)
include_directories(${CMAKE_BINARY_DIR}/generated/policy)

# Collects a layer's own sources: every .cpp below the folder that is neither a test, nor a benchmark, nor
# reached through a .def list.
function(phytobench_layer_sources OUT)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.cpp)
  list(FILTER sources EXCLUDE REGEX "_(test|benchmark)\\.cpp$")
  foreach(pattern IN LISTS ARGN)
    list(FILTER sources EXCLUDE REGEX "${pattern}")
  endforeach()
  set(${OUT} ${sources} PARENT_SCOPE)
endfunction()

# A library for one layer; includes are written from the project's root.
function(phytobench_layer NAME)
  add_library(${NAME} STATIC ${ARGN})
  target_include_directories(${NAME} PUBLIC ${PROJECT_SOURCE_DIR})
  if(PHYTOBENCH_SANITIZERS)
    phytobench_in_batches(${NAME})
    # In a batch every file but the first looks like a header to the compiler.
    target_compile_options(${NAME} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()
