# SPDX-License-Identifier: GPL-3.0-or-later
# The choice of what is built, and the flags that every target of the project shares.
include(FeatureSummary)

option(FRETWORK_BUILD_APPS "Build the command line" ${PROJECT_IS_TOP_LEVEL})
option(FRETWORK_BUILD_EXPERIMENTS "Build the programs of experiments/" ${PROJECT_IS_TOP_LEVEL})
option(FRETWORK_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(FRETWORK_STAGE_TESTS "Build the tests of the stages, if tests are built" ON)
option(FRETWORK_LONG_TESTS "Add tests that start services or take long: those of make check" OFF)
option(FRETWORK_BUILD_BENCH "Build the benchmarks" OFF)
option(FRETWORK_BUILD_PYTHON "Build the Python module" OFF)
option(FRETWORK_SHARED_LIBRARY "Install the stages as one shared library, in the place of their archives" OFF)
option(FRETWORK_WARNINGS_AS_ERRORS "Treat warnings as errors" OFF)
option(FRETWORK_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)
option(FRETWORK_FUZZ "Build the program that libFuzzer drives; needs clang" OFF)
option(FRETWORK_SANITIZE_THREADS "Build with the thread sanitizer, which goes with no other" OFF)
foreach(name APPS EXPERIMENTS TESTS BENCH PYTHON)
  add_feature_info(FRETWORK_BUILD_${name} FRETWORK_BUILD_${name} "")
endforeach()
add_feature_info(FRETWORK_SHARED_LIBRARY FRETWORK_SHARED_LIBRARY "")
add_feature_info(FRETWORK_SANITIZE FRETWORK_SANITIZE "")
add_feature_info(FRETWORK_SANITIZE_THREADS FRETWORK_SANITIZE_THREADS "")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# Linked privately by every target: it never reaches a user of the installed library.
add_library(fretwork_flags INTERFACE)
target_compile_features(fretwork_flags INTERFACE cxx_std_20)
# Exact predicates and printed tables must not depend on whether a machine contracts a*b+c. One kernel of the
# factorization does contract (framework/fretwork/mechanics/CMakeLists.txt), the same way on every x86-64.
target_compile_options(fretwork_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                                -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # False alarms: on std::string (GCC bug 105651), and on members with initializers where an exception passes.
  target_compile_options(fretwork_flags INTERFACE -Wno-restrict -Wno-maybe-uninitialized)
endif()
if(FRETWORK_WARNINGS_AS_ERRORS)
  target_compile_options(fretwork_flags INTERFACE -Werror)
endif()
if(FRETWORK_SANITIZE)
  # A number too large for the integer it is cast to: in clang's group "undefined", and not in GCC's.
  target_compile_options(fretwork_flags INTERFACE -fsanitize=address,undefined,float-cast-overflow
                                                  -fno-sanitize-recover=undefined,float-cast-overflow -fno-omit-frame-pointer)
  target_link_options(fretwork_flags INTERFACE -fsanitize=address,undefined)
  # Linked after the flags, so that it comes behind them: for sources in which CGAL casts objects down to classes without
  # members of their own.
  add_library(fretwork_no_vptr INTERFACE)
  target_compile_options(fretwork_no_vptr INTERFACE -fno-sanitize=vptr)
  # False alarms under these options, as GCC's manual says of them: in std::regex, CGAL and OpenMesh.
  target_compile_options(fretwork_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  # An empty optional, a place behind the end of a vector: the library stops there.
  target_compile_definitions(fretwork_flags INTERFACE _GLIBCXX_ASSERTIONS)
  # Under the address sanitizer Eigen keeps some room before each block, and libraries of the system that share
  # its matrices (pagmo) do not: free() would miss the start. The sanitizer's malloc is aligned to 16 bytes, as any.
  target_compile_definitions(fretwork_flags INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
endif()
if(FRETWORK_FUZZ)
  target_compile_options(fretwork_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(FRETWORK_SANITIZE_THREADS)
  target_compile_options(fretwork_flags INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(fretwork_flags INTERFACE -fsanitize=thread)
endif()
