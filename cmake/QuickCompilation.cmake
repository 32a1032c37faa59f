# SPDX-License-Identifier: GPL-3.0-or-later
# What makes a build from nothing quick: several sources are compiled as one (they share what headers cost and the
# templates that they instantiate), and the headers that nearly every source includes are read once.
# Neither changes the meaning of a source: the presets with sanitizers and assertions compile each by itself, so that
# each also names the headers that it needs.
option(FRETWORK_QUICK_COMPILATION "Compile several sources at once, with precompiled headers" OFF)
set(FRETWORK_SOURCES_AT_ONCE 12 CACHE STRING "How many sources are compiled as one")

# Headers that many sources of all targets include.
set(FRETWORK_COMMON_HEADERS
  <algorithm> <array> <cmath> <cstdint> <cstdio> <filesystem> <functional> <limits> <map> <memory> <mutex> <numbers>
  <numeric> <optional> <set> <span> <string> <string_view> <thread> <tuple> <unordered_map> <utility> <vector>
  <Eigen/Core> <Eigen/Geometry>)

if(FRETWORK_QUICK_COMPILATION)
  # One precompiled header for libraries and programs: all of them need code that may lie anywhere.
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
  file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/precompiled.cpp" CONTENT "// Holds the precompiled header of all targets.\n")
  add_library(fretwork_precompiled OBJECT "${PROJECT_BINARY_DIR}/precompiled.cpp")
  target_link_libraries(fretwork_precompiled PRIVATE fretwork_flags Eigen3::Eigen)
  set_target_properties(fretwork_precompiled PROPERTIES CXX_EXTENSIONS OFF)
  target_precompile_headers(fretwork_precompiled PRIVATE ${FRETWORK_COMMON_HEADERS})
endif()

# The precompiled header of all test programs. They are compiled with little optimization, since what they test is not.
if(FRETWORK_QUICK_COMPILATION AND FRETWORK_BUILD_TESTS)
  add_library(fretwork_precompiled_tests OBJECT "${PROJECT_BINARY_DIR}/precompiled.cpp")
  target_link_libraries(fretwork_precompiled_tests PRIVATE fretwork_flags Eigen3::Eigen GTest::gmock GTest::gtest)
  target_compile_options(fretwork_precompiled_tests PRIVATE -O1)
  # As programs are compiled, and libraries are not.
  set_target_properties(fretwork_precompiled_tests PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE OFF)
  target_precompile_headers(fretwork_precompiled_tests PRIVATE ${FRETWORK_COMMON_HEADERS} <gmock/gmock.h> <gtest/gtest.h>)
endif()

# fretwork_compile_quickly(<target>): a library or program.
function(fretwork_compile_quickly target)
  if(NOT FRETWORK_QUICK_COMPILATION)
    return()
  endif()
  # GCC takes a class that is private to one source, and is the member of another class, for one that several
  # sources see. In large sources it also believes that texts may have a negative length.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage -Wno-stringop-overflow>)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${FRETWORK_SOURCES_AT_ONCE}
                                             CXX_EXTENSIONS OFF)
  target_precompile_headers(${target} REUSE_FROM fretwork_precompiled)
endfunction()

# fretwork_compile_tests_quickly(<target>): a program of tests. Helpers in different sources have the same names: the
# namespace THIS_TEST keeps them apart where sources are compiled as one, and has no name elsewhere.
function(fretwork_compile_tests_quickly target)
  if(NOT FRETWORK_QUICK_COMPILATION)
    target_compile_definitions(${target} PRIVATE THIS_TEST=)
    return()
  endif()
  target_compile_options(${target} PRIVATE -O1 $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${FRETWORK_SOURCES_AT_ONCE}
                                             UNITY_BUILD_UNIQUE_ID THIS_TEST
                                             CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE OFF)
  target_precompile_headers(${target} REUSE_FROM fretwork_precompiled_tests)
endfunction()
