# SPDX-License-Identifier: GPL-3.0-or-later
# A quick build from nothing: several sources are compiled as one (they share what headers cost and the
# templates that they instantiate), and the headers that nearly every source includes are read once.
# Neither changes the meaning of a source. The preset dev compiles each by itself, and `make check` each header, so that
# each names the headers that it needs.
option(FRETWORK_QUICK_COMPILATION "Compile several sources at once, with precompiled headers" OFF)
set(FRETWORK_SOURCES_AT_ONCE 12 CACHE STRING "How many sources are compiled as one")

# Headers that many sources of all targets include.
set(FRETWORK_COMMON_HEADERS
  <algorithm> <array> <cmath> <cstdint> <cstdio> <filesystem> <functional> <limits> <map> <memory> <mutex> <numbers>
  <numeric> <optional> <set> <span> <string> <string_view> <thread> <tuple> <unordered_map> <utility> <vector>
  <Eigen/Core> <Eigen/Geometry>)

# fretwork_add_precompiled_headers(<target> OPTIONS flags.. HEADERS more.. LINK targets..): headers that targets compiled
# with these options share.
function(fretwork_add_precompiled_headers target)
  cmake_parse_arguments(ARG "" "" "OPTIONS;HEADERS;LINK" ${ARGN})
  file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/precompiled.cpp" CONTENT "// Holds the precompiled header of all targets.\n")
  add_library(${target} OBJECT "${PROJECT_BINARY_DIR}/precompiled.cpp")
  target_link_libraries(${target} PRIVATE fretwork_flags Eigen3::Eigen ${ARG_LINK})
  target_compile_options(${target} PRIVATE ${ARG_OPTIONS})
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_precompile_headers(${target} PRIVATE ${FRETWORK_COMMON_HEADERS} ${ARG_HEADERS})
endfunction()

if(FRETWORK_QUICK_COMPILATION)
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)  # for all, so that all can share
  fretwork_add_precompiled_headers(fretwork_precompiled OPTIONS -fPIC)
  # Programs read files, call stages and print; tests call stages. Little optimization is enough for both.
  fretwork_add_precompiled_headers(fretwork_precompiled_programs OPTIONS -fPIC -O1)
endif()
if(FRETWORK_QUICK_COMPILATION AND FRETWORK_BUILD_TESTS)
  fretwork_add_precompiled_headers(fretwork_precompiled_tests OPTIONS -fPIC -O1
    HEADERS <gmock/gmock.h> <gtest/gtest.h> LINK GTest::gmock GTest::gtest)
endif()

# Several sources at once, with the headers that `precompiled` holds, compiled with `options`.
function(fretwork_share_compilation target precompiled options)
  # GCC takes a class that is private to one source, and is the member of another class, for one that several
  # sources see. In large sources it also believes that texts may have a negative length.
  target_compile_options(${target} PRIVATE -fPIC ${options}
    $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage -Wno-stringop-overflow -Wno-array-bounds -Wno-maybe-uninitialized>)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${FRETWORK_SOURCES_AT_ONCE}
                                             CXX_EXTENSIONS OFF)
  target_precompile_headers(${target} REUSE_FROM ${precompiled})
endfunction()

# fretwork_compile_quickly(<target> [NO_INNER_LOOPS]): a library, or the program of an experiment. NO_INNER_LOOPS: its
# time goes into calls of other stages and of libraries, or into reading and writing.
function(fretwork_compile_quickly target)
  cmake_parse_arguments(ARG "NO_INNER_LOOPS" "" "" ${ARGN})
  if(FRETWORK_QUICK_COMPILATION AND ARG_NO_INNER_LOOPS)
    fretwork_share_compilation(${target} fretwork_precompiled_programs -O1)
  elseif(FRETWORK_QUICK_COMPILATION)
    fretwork_share_compilation(${target} fretwork_precompiled "")
  endif()
endfunction()

# fretwork_compile_program_quickly(<target>): sources of the command line and the studio.
function(fretwork_compile_program_quickly target)
  if(FRETWORK_QUICK_COMPILATION)
    fretwork_share_compilation(${target} fretwork_precompiled_programs -O1)
  endif()
endfunction()

# fretwork_compile_tests_quickly(<target>): a program of tests. Helpers in different sources have the same names: the
# namespace THIS_TEST keeps them apart where sources are compiled as one, and has no name elsewhere.
function(fretwork_compile_tests_quickly target)
  if(FRETWORK_QUICK_COMPILATION)
    fretwork_share_compilation(${target} fretwork_precompiled_tests -O1)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_UNIQUE_ID THIS_TEST)
  else()
    target_compile_definitions(${target} PRIVATE THIS_TEST=)
  endif()
endfunction()
