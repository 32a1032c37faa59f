# SPDX-License-Identifier: GPL-3.0-or-later
# Every library that the project builds on, in one place. Versions, licences and reasons: third_party_notes.md.
find_package(Threads REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)                      # base: JSON
find_library(NETTLE_LIBRARY nettle REQUIRED)                   # base: SHA-256 (Debian ships no CMake package)
find_path(NETTLE_INCLUDE_DIR nettle/sha2.h REQUIRED)
if(NOT TARGET nettle::nettle)
  add_library(nettle::nettle UNKNOWN IMPORTED)
  set_target_properties(nettle::nettle PROPERTIES IMPORTED_LOCATION "${NETTLE_LIBRARY}"
                                                  INTERFACE_INCLUDE_DIRECTORIES "${NETTLE_INCLUDE_DIR}")
endif()
find_package(Eigen3 3.4 REQUIRED NO_MODULE)                    # mechanics and after: matrices
find_package(CHOLMOD REQUIRED)                                 # mechanics: elimination orders
find_package(Ceres 2.1 REQUIRED)                               # optimization: least squares
find_package(NLopt 2.7 REQUIRED)                               # optimization: methods to compare with
find_package(Boost 1.74 REQUIRED)                              # pattern: Boost.Graph, Boost.Multiprecision (headers)
find_package(pagmo 2.18 REQUIRED)                              # optimization: likewise
# Its archive and not its shared library: to load that takes a program 20 ms and 24 MB, whatever it does then.
find_library(PAGMO_ARCHIVE libpagmo.a REQUIRED)
find_library(BOOST_SERIALIZATION_ARCHIVE libboost_serialization.a REQUIRED)
find_package(TBB REQUIRED)
if(NOT TARGET pagmo::archive)
  add_library(pagmo::archive UNKNOWN IMPORTED)
  set_target_properties(pagmo::archive PROPERTIES IMPORTED_LOCATION "${PAGMO_ARCHIVE}")
  target_link_libraries(pagmo::archive INTERFACE NLopt::nlopt "${BOOST_SERIALIZATION_ARCHIVE}" TBB::tbb Boost::boost
                                                 Eigen3::Eigen Threads::Threads)
endif()

# Objects of the archive know their place, so a module takes the shared library.
if(NOT TARGET pagmo::methods)
  add_library(pagmo::methods INTERFACE IMPORTED)
  target_link_libraries(pagmo::methods INTERFACE
    $<IF:$<BOOL:$<TARGET_PROPERTY:FRETWORK_IS_MODULE>>,Pagmo::pagmo,pagmo::archive>)
endif()
find_package(CGAL 5.5 REQUIRED)                                # geometry, pattern: exact predicates; outlines: arrangements; tiling: remeshing
find_package(pugixml 1.12 REQUIRED)                          # outlines: SVG
find_package(SQLite3 3.40 REQUIRED)                          # library
find_package(PNG 1.6 REQUIRED)                               # tiling: images to paint by; exports: pictures
find_package(Freetype 2.12 REQUIRED)                         # exports: letters in pictures
find_library(MUPARSER_LIBRARY muparser REQUIRED)             # tiling: expressions to paint by
find_path(MUPARSER_INCLUDE_DIR muParser.h REQUIRED)
if(NOT TARGET muparser::library)
  add_library(muparser::library UNKNOWN IMPORTED)
  set_target_properties(muparser::library PROPERTIES IMPORTED_LOCATION "${MUPARSER_LIBRARY}"
                                                     INTERFACE_INCLUDE_DIRECTORIES "${MUPARSER_INCLUDE_DIR}")
endif()
# exports: 3MF. Debian's CMake package of it asks for its programs, too.
find_library(ZIP_LIBRARY zip REQUIRED)
find_path(ZIP_INCLUDE_DIR zip.h REQUIRED)
add_library(libzip::zip UNKNOWN IMPORTED)
set_target_properties(libzip::zip PROPERTIES IMPORTED_LOCATION "${ZIP_LIBRARY}"
                                             INTERFACE_INCLUDE_DIRECTORIES "${ZIP_INCLUDE_DIR}")
find_package(CLI11 2.1 REQUIRED)                             # apps: the command line
find_library(CLIPPER_LIBRARY polyclipping REQUIRED)          # fabrication: Booleans (Debian ships no CMake package)
find_path(CLIPPER_INCLUDE_DIR polyclipping/clipper.hpp REQUIRED)
add_library(Clipper::Clipper UNKNOWN IMPORTED)
set_target_properties(Clipper::Clipper PROPERTIES IMPORTED_LOCATION "${CLIPPER_LIBRARY}"
                                                  INTERFACE_INCLUDE_DIRECTORIES "${CLIPPER_INCLUDE_DIR}")
find_library(OPENMESH_CORE_LIBRARY OpenMeshCore REQUIRED)    # outlines: rims of meshes (Debian ships no CMake package)
find_path(OPENMESH_INCLUDE_DIR OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh REQUIRED)
add_library(OpenMesh::Core UNKNOWN IMPORTED)
set_target_properties(OpenMesh::Core PROPERTIES IMPORTED_LOCATION "${OPENMESH_CORE_LIBRARY}"
                                                INTERFACE_INCLUDE_DIRECTORIES "${OPENMESH_INCLUDE_DIR}")
find_library(NAUTY_LIBRARY nauty REQUIRED)                   # pattern: isomorphism classes (no CMake package either)
find_path(NAUTY_INCLUDE_DIR nauty/nauty.h REQUIRED)
add_library(nauty::nauty UNKNOWN IMPORTED)
set_target_properties(nauty::nauty PROPERTIES IMPORTED_LOCATION "${NAUTY_LIBRARY}"
                                              INTERFACE_INCLUDE_DIRECTORIES "${NAUTY_INCLUDE_DIR}")

if(FRETWORK_BUILD_BENCH)
  find_package(GTest 1.12 REQUIRED)
elseif(FRETWORK_BUILD_TESTS)
  find_package(GTest 1.12)  # not in the packages of `make demo`, whose targets do not need it
  if(NOT GTest_FOUND)
    message(STATUS "GoogleTest 1.12 is not installed: no tests are built")
    set(FRETWORK_BUILD_TESTS OFF)
  endif()
endif()
if(FRETWORK_BUILD_BENCH)
  find_package(benchmark 1.7 REQUIRED)
endif()
if(FRETWORK_BUILD_PYTHON)                                       # apps: the Python module
  if(NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3 AND EXISTS /usr/lib/cmake/pybind11)
    set(Python3_EXECUTABLE /usr/bin/python3)  # Debian's: another one in the PATH has no headers of Debian's packages
  endif()
  find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter Development.Module)
  set(PYBIND11_NOPYTHON ON)
  find_package(pybind11 2.10 REQUIRED)
endif()
