# What `cmake --install` copies, in two components: `program` is what one runs, `development` what one builds with. With
# sanitizers nothing is installed: whoever links such a library needs them, too.
if(PHYTOBENCH_SANITIZERS)
  return()
endif()
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The program looks for its data in ../share/phytobench, and for the worker and its description beside itself.
install(TARGETS phytobench phytobench_worker RUNTIME DESTINATION bin COMPONENT program)
install(FILES ${CMAKE_BINARY_DIR}/worker_build.json DESTINATION bin COMPONENT program)
# The program opens it by its place, ../lib/phytobench, whatever the folder for libraries is called.
if(TARGET phytobench_gdal)
  install(TARGETS phytobench_gdal LIBRARY DESTINATION lib/phytobench COMPONENT program)
endif()
get_property(data_folders GLOBAL PROPERTY PHYTOBENCH_DATA_FOLDERS)
install(DIRECTORY ${data_folders} reports/templates reports/studies
        DESTINATION share/phytobench COMPONENT program)
install(FILES LICENSE CITATION.cff README.md DESTINATION share/doc/phytobench COMPONENT program)

# The library with its headers, in the folders they lie in: they include each other as "core/...". Those of tests stay.
install(TARGETS phytobench_core ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} core/*.hpp core/*.h)
list(FILTER headers EXCLUDE REGEX "/test_[a-z_]+\\.hpp$|_(fixture|oracle)\\.hpp$")
foreach(header IN LISTS headers)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${header} DESTINATION include/phytobench/${folder} COMPONENT development)
endforeach()
install(FILES ${CMAKE_BINARY_DIR}/generated/policy/counting_policy.hpp DESTINATION include/phytobench COMPONENT development)
# A plugin in C needs this file alone; the example finds it through the package.
install(FILES core/nearest_node/plugin/phytobench_engine.h DESTINATION include COMPONENT development)
install(DIRECTORY examples/plugin DESTINATION share/phytobench/examples COMPONENT development
        PATTERN faulty EXCLUDE)

# What the library needs when linked, from its own list: a package for each target, and how it is linked. `headers`:
# nothing, only our sources include them; `link`: linked, not seen; `use`: our headers include it, too.
set(known_dependencies
  "fmt::fmt|use|fmt 9" "hwy::hwy|use|hwy 1.0" "tomlplusplus::tomlplusplus|use|tomlplusplus 3.3"
  "nlohmann_json::nlohmann_json|use|nlohmann_json 3.11"
  "TBB::tbb|link|TBB 2021.8" "OpenSSL::Crypto|link|OpenSSL 3.0 COMPONENTS Crypto"
  "CGAL::CGAL|link|CGAL 5.5" "embree|link|embree 3.13"
  "flann_headers|link|lz4" "libnova|link|nova" "nanoflann::nanoflann|headers|" "Boost::headers|headers|" "random123|headers|" "stb|headers|"
  "build_information|headers|")
# Those two come without a CMake package.
set(find_library_text [=[
find_library(PHYTOBENCH_@NAME@_LIBRARY @name@)
if(NOT PHYTOBENCH_@NAME@_LIBRARY)
  set(phytobench_FOUND FALSE)
  set(phytobench_NOT_FOUND_MESSAGE "the library @name@ was not found")
  return()
endif()
]=])
# Sets what the package file has to find and what its target links. System libraries (dl) are linked by name.
function(phytobench_installed_dependencies TARGET OUT_FIND OUT_LINK)
  get_target_property(libraries ${TARGET} LINK_LIBRARIES)
  string(REGEX REPLACE "\\$<LINK_ONLY:([^>]+)>" "\\1" libraries "${libraries}")
  list(REMOVE_DUPLICATES libraries)
  set(find "")
  set(link "")
  foreach(library IN LISTS libraries)
    set(known ${known_dependencies})
    list(FILTER known INCLUDE REGEX "^${library}\\|")
    if(known MATCHES "\\|headers\\|$")
      continue()
    elseif(known MATCHES "\\|link\\|(lz4|nova)$")
      set(name ${CMAKE_MATCH_1})
      string(TOUPPER ${name} NAME)
      string(CONFIGURE "${find_library_text}" find_it @ONLY)
      string(APPEND find "${find_it}")
      list(APPEND link "$<LINK_ONLY:\${PHYTOBENCH_${NAME}_LIBRARY}>")
    elseif(known MATCHES "\\|link\\|(.+)$")
      string(APPEND find "find_dependency(${CMAKE_MATCH_1})\n")
      list(APPEND link "$<LINK_ONLY:${library}>")
    elseif(known MATCHES "\\|use\\|(.+)$")
      string(APPEND find "find_dependency(${CMAKE_MATCH_1})\n")
      list(APPEND link ${library})
    elseif(library MATCHES "^[a-z]+$" AND NOT TARGET ${library})
      list(APPEND link "$<LINK_ONLY:${library}>")
    else()
      message(FATAL_ERROR "cmake/install.cmake does not know which package ${library} comes from; add it to known_dependencies")
    endif()
  endforeach()
  set(${OUT_FIND} "${find}" PARENT_SCOPE)
  set(${OUT_LINK} "${link}" PARENT_SCOPE)
endfunction()
phytobench_installed_dependencies(phytobench_core PHYTOBENCH_FIND_DEPENDENCIES PHYTOBENCH_LINK_DEPENDENCIES)

set(PHYTOBENCH_HAS_GPL OFF)
if(PHYTOBENCH_FIND_DEPENDENCIES MATCHES "CGAL")
  set(PHYTOBENCH_HAS_GPL ON)
endif()
set(PHYTOBENCH_HEADERS include/phytobench)
set(PHYTOBENCH_C_HEADERS include)
set(PHYTOBENCH_ARCHIVE ${CMAKE_INSTALL_LIBDIR}/${CMAKE_STATIC_LIBRARY_PREFIX}phytobench_core${CMAKE_STATIC_LIBRARY_SUFFIX})
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/phytobench)
configure_package_config_file(cmake/phytobench-config.cmake.in ${CMAKE_BINARY_DIR}/generated/package/phytobench-config.cmake
  INSTALL_DESTINATION ${package_folder} PATH_VARS PHYTOBENCH_HEADERS PHYTOBENCH_C_HEADERS PHYTOBENCH_ARCHIVE)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/generated/package/phytobench-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/generated/package/phytobench-config.cmake
              ${CMAKE_BINARY_DIR}/generated/package/phytobench-config-version.cmake
        DESTINATION ${package_folder} COMPONENT development)

# All of that, as somebody else would use it.
add_test(NAME InstalledLibraryForOthersSlow
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILD=${CMAKE_BINARY_DIR} -D VERSION=${PROJECT_VERSION}
    -D GENERATOR=${CMAKE_GENERATOR} -D MAKE_PROGRAM=${CMAKE_MAKE_PROGRAM} -D COMPILER=${CMAKE_CXX_COMPILER}
    -P ${PROJECT_SOURCE_DIR}/cmake/consumer_test.cmake)
set_tests_properties(InstalledLibraryForOthersSlow PROPERTIES LABELS slow TIMEOUT 600)
