# Every outside library, once. Package names and traps: cmake/packages.txt.
find_package(Threads REQUIRED)
find_package(TBB 2021.8 REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(tomlplusplus 3.3 REQUIRED)
find_package(hwy 1.0 REQUIRED)
find_package(GTest 1.12 REQUIRED)
find_package(OpenSSL 3.0 REQUIRED COMPONENTS Crypto)
find_package(SQLite3 3.40 REQUIRED)
find_package(benchmark 1.7)

# Peers of the nearest-node engines. Whatever is missing shows as "not built".
find_package(nanoflann 1.4 QUIET)
if(PHYTOBENCH_WITH_GPL)
  find_package(CGAL 5.5 QUIET)
endif()
# The package's own target links whole static archives, its pkg-config file MPI and HDF5; the headers need only lz4.
find_path(FLANN_INCLUDE_FOLDER flann/flann.hpp)
find_library(LZ4_LIBRARY lz4)
if(FLANN_INCLUDE_FOLDER AND LZ4_LIBRARY)
  add_library(flann_headers INTERFACE)
  target_include_directories(flann_headers SYSTEM INTERFACE ${FLANN_INCLUDE_FOLDER})
  target_link_libraries(flann_headers INTERFACE ${LZ4_LIBRARY})
endif()

# Header-only libraries without a CMake package of their own.
function(phytobench_header_library NAME HEADER)
  find_path(${NAME}_INCLUDE_FOLDER ${HEADER} REQUIRED)
  add_library(${NAME} INTERFACE)
  target_include_directories(${NAME} SYSTEM INTERFACE ${${NAME}_INCLUDE_FOLDER})
endfunction()

phytobench_header_library(random123 Random123/philox.h)
phytobench_header_library(mustache kainjow/mustache.hpp)
phytobench_header_library(stb stb/stb_image_write.h)

# Pictures of meshes. Where it is missing, asking for one says so.
find_package(embree 3.13 QUIET)
# Reads and writes maps in the formats that have no reader of our own.
find_package(GDAL 3.6 QUIET)
# Where the sun stands on a day. Comes without a CMake package.
find_path(NOVA_INCLUDE_FOLDER libnova/solar.h)
find_library(NOVA_LIBRARY nova)
if(NOVA_INCLUDE_FOLDER AND NOVA_LIBRARY)
  add_library(libnova INTERFACE)
  target_include_directories(libnova SYSTEM INTERFACE ${NOVA_INCLUDE_FOLDER})
  target_link_libraries(libnova INTERFACE ${NOVA_LIBRARY})
endif()
# Reads exported files back in tests, which are left out where it is missing.
find_package(assimp 5.2 QUIET)
# Reads the report's junit.xml back in a test.
find_package(LibXml2 2.9 QUIET)

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Paths below the sources count from there, so that another copy of them need not be compiled again.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CCACHE})
endif()
