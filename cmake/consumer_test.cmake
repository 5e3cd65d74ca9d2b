# Installs the suite into a folder of its own, moves that, and uses it as somebody else would: the program from another
# folder, and the library in examples/consumer, copied out of the source tree. Takes SOURCE, BUILD, VERSION, GENERATOR,
# MAKE_PROGRAM and COMPILER.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND mktemp -d OUTPUT_VARIABLE folder OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)

function(give_up WHY)
  file(REMOVE_RECURSE ${folder})
  message(FATAL_ERROR "${WHY}")
endfunction()

# Runs a command in the test's folder; OUT becomes what it printed on both streams. WHAT says what failed.
function(must_run WHAT OUT)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${folder} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    give_up("${WHAT} failed (${result}):\n${output}")
  endif()
  set(${OUT} "${output}" PARENT_SCOPE)
endfunction()

function(must_match WHAT TEXT PATTERN)
  if(NOT TEXT MATCHES "${PATTERN}")
    give_up("${WHAT}: expected ${PATTERN}, got:\n${TEXT}")
  endif()
endfunction()

# Whether the text names one of the folders that an installed file must not know.
function(names_a_build_folder TEXT OUT)
  set(${OUT} FALSE PARENT_SCOPE)
  foreach(path ${SOURCE} ${BUILD} ${folder})
    string(FIND "${TEXT}" "${path}" place)
    if(NOT place EQUAL -1)
      set(${OUT} TRUE PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

must_run("installing" ignored ${CMAKE_COMMAND} --install ${BUILD} --prefix ${folder}/first)
set(prefix ${folder}/moved)
file(RENAME ${folder}/first ${prefix})

# The package knows no path of this machine.
names_a_build_folder("set(x ${BUILD}/lib)" found)
if(NOT found)
  give_up("the check for paths finds none where there is one")
endif()
file(GLOB_RECURSE packages ${prefix}/lib*/cmake/phytobench/*.cmake)
list(LENGTH packages count)
if(NOT count EQUAL 2)
  give_up("expected a package file and a version file, got: ${packages}")
endif()
foreach(package IN LISTS packages)
  file(READ ${package} text)
  names_a_build_folder("${text}" found)
  if(found)
    give_up("${package} names a folder of this build")
  endif()
endforeach()
foreach(file include/phytobench_engine.h include/phytobench/core/overlap/lens.hpp share/phytobench/examples/plugin/README.md)
  if(NOT EXISTS ${prefix}/${file})
    give_up("${file} was not installed")
  endif()
endforeach()

# The program finds its data, whatever the folder it is called from.
set(clean ${CMAKE_COMMAND} -E env --unset=PHYTOBENCH_DATA)
set(program ${clean} ${prefix}/bin/phytobench)
must_run("phytobench --version" output ${program} --version)
must_match("phytobench --version" "${output}" "phytobench ${VERSION}")
must_run("phytobench list papers" output ${program} list papers)
must_match("phytobench list papers" "${output}" "brzoska2019")
must_run("phytobench list presets" output ${program} list presets)
must_match("phytobench list presets" "${output}" "birch")
must_run("phytobench_worker list" output ${clean} ${prefix}/bin/phytobench_worker list)
must_match("phytobench_worker list" "${output}" "nearest-node/node_driven/dn")
if(EXISTS ${BUILD}/modules/phytobench_gdal.so)
  must_run("phytobench doctor" output ${program} doctor)
  must_match("phytobench doctor" "${output}" "map_formats +GDAL 3")
endif()

# The library in a project of its own.
file(COPY ${SOURCE}/examples/consumer DESTINATION ${folder})
set(configure ${CMAKE_COMMAND} -G ${GENERATOR} -D CMAKE_MAKE_PROGRAM=${MAKE_PROGRAM} -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH=${prefix})
must_run("configuring the example" ignored ${configure} -S ${folder}/consumer -B ${folder}/build)
must_run("building the example" ignored ${CMAKE_COMMAND} --build ${folder}/build)
must_run("the example" output ${folder}/build/consumer)
must_match("the example" "${output}" "node_driven and squared_scan grow the same tree of [1-9][0-9]+ edges")
must_match("the example" "${output}" "discs 0 and 1 share 1\\.228369698609")
must_match("the example" "${output}" "2 of 3 pairs overlap")

# A plugin, from the example as it was installed. It must not need a package that the library was built with.
set(own_plugin ${folder}/plugin-build/nearest_scan.so)
file(COPY ${prefix}/share/phytobench/examples/plugin DESTINATION ${folder})
set(configure_plugin ${CMAKE_COMMAND} -G ${GENERATOR} -D CMAKE_MAKE_PROGRAM=${MAKE_PROGRAM} -D CMAKE_PREFIX_PATH=${prefix})
foreach(package fmt TBB OpenSSL nlohmann_json tomlplusplus hwy)
  list(APPEND configure_plugin -D CMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
must_run("configuring the plugin" ignored ${configure_plugin} -S ${folder}/plugin -B ${folder}/plugin-build)
must_run("building the plugin" output ${CMAKE_COMMAND} --build ${folder}/plugin-build --verbose)
must_match("building the plugin" "${output}" "-ffp-contract=off")
must_match("building the plugin" "${output}" "${prefix}/include")
must_run("racing the plugin" output ${program} race nearest-node --plugin ${own_plugin} --engines node_driven --options dn
         --points 500 --rounds 1)
must_match("racing the plugin" "${output}" "nearest_scan.so: exact")

# Without components, and for the library, those packages are wanted.
file(WRITE ${folder}/whole/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)\nproject(whole LANGUAGES CXX)\n"
     "find_package(phytobench 0.1 QUIET CONFIG COMPONENTS \${WANTED})\n"
     "message(\"found: \${phytobench_FOUND}, \${phytobench_NOT_FOUND_MESSAGE}\")\n")
set(ask ${CMAKE_COMMAND} -G ${GENERATOR} -D CMAKE_MAKE_PROGRAM=${MAKE_PROGRAM} -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_PREFIX_PATH=${prefix} -S ${folder}/whole)
must_run("asking for core" output ${ask} -B ${folder}/whole-core -D WANTED=core)
must_match("asking for core" "${output}" "found: (1|TRUE)")
must_run("asking for core without fmt" output ${ask} -B ${folder}/whole-less -D WANTED=core -D CMAKE_DISABLE_FIND_PACKAGE_fmt=ON)
must_match("asking for core without fmt" "${output}" "found: (0|FALSE)")
must_run("asking for a roof" output ${ask} -B ${folder}/whole-roof -D WANTED=roof)
must_match("asking for a roof" "${output}" "found: (0|FALSE)")

# Version 0.1 stands for no other.
file(WRITE ${folder}/later/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)\nproject(later LANGUAGES NONE)\n"
     "find_package(phytobench \${WANTED} QUIET CONFIG)\nmessage(\"considered \${phytobench_CONSIDERED_VERSIONS}\")\n"
     "if(phytobench_FOUND)\n  message(\"taken\")\nendif()\n")
foreach(wanted 0.2 1.0)
  must_run("asking for ${wanted}" output ${CMAKE_COMMAND} -S ${folder}/later -B ${folder}/later-${wanted}
           -G ${GENERATOR} -D CMAKE_MAKE_PROGRAM=${MAKE_PROGRAM} -D WANTED=${wanted} -D CMAKE_PREFIX_PATH=${prefix})
  must_match("asking for ${wanted}" "${output}" "considered ${VERSION}")
  if(output MATCHES "taken")
    give_up("a package of version ${VERSION} was taken for ${wanted}")
  endif()
endforeach()

file(REMOVE_RECURSE ${folder})
