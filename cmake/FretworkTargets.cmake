# SPDX-License-Identifier: GPL-3.0-or-later
# One helper for each kind of target, so that a stage's own CMakeLists.txt says only what is its own.

# fretwork_add_stage(<stage> [NO_INNER_LOOPS] SOURCES a.cpp.. HEADERS a.hpp.. [PUBLIC targets..] [PRIVATE targets..])
# The target is fretwork_<stage>, with the alias fretwork::<stage>; headers lie beside sources. NO_INNER_LOOPS: see
# fretwork_compile_quickly.
function(fretwork_add_stage stage)
  cmake_parse_arguments(ARG "NO_INNER_LOOPS" "" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  set(target fretwork_${stage})
  add_library(${target} STATIC)
  add_library(fretwork::${stage} ALIAS ${target})
  target_sources(${target}
    PRIVATE ${ARG_SOURCES}
    PUBLIC FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/framework" FILES ${ARG_HEADERS})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/framework>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${stage} POSITION_INDEPENDENT_CODE ON CXX_EXTENSIONS OFF)
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:fretwork_flags>)
  if(ARG_NO_INNER_LOOPS)
    fretwork_compile_quickly(${target} NO_INNER_LOOPS)
  else()
    fretwork_compile_quickly(${target})
  endif()
  set_property(GLOBAL APPEND PROPERTY FRETWORK_STAGES ${target})
endfunction()

# fretwork_add_tests(<label> SOURCES a_test.cpp.. LINK targets.. [ENVIRONMENT NAME=VALUE]): one program, every TEST of it
# known to CTest. Under a sanitizer it is every suite: there a process takes longer to begin and to end than most tests.
function(fretwork_add_tests label)
  cmake_parse_arguments(ARG "" "ENVIRONMENT" "SOURCES;LINK" ${ARGN})
  set(target fretwork_${label}_tests)
  add_executable(${target} ${ARG_SOURCES})
  target_link_libraries(${target} PRIVATE ${ARG_LINK} GTest::gmock GTest::gtest_main fretwork_flags)
  target_compile_definitions(${target} PRIVATE FRETWORK_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/tests")
  fretwork_compile_tests_quickly(${target})
  if(FRETWORK_SANITIZE OR FRETWORK_SANITIZE_THREADS)
    fretwork_discover_suites(${target} ${label} "${ARG_ENVIRONMENT}")
  else()
    set(properties LABELS ${label})
    if(ARG_ENVIRONMENT)
      list(APPEND properties ENVIRONMENT "${ARG_ENVIRONMENT}")
    endif()
    gtest_discover_tests(${target} TEST_PREFIX "${label}." PROPERTIES ${properties} DISCOVERY_TIMEOUT 60)
  endif()
endfunction()

# fretwork_discover_suites(<target> <label> <environment>): every suite of a built test program known to CTest.
function(fretwork_discover_suites target label environment)
  set(list "${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake")
  add_custom_command(TARGET ${target} POST_BUILD
    COMMAND ${CMAKE_COMMAND} -D "PROGRAM=$<TARGET_FILE:${target}>" -D "LIST=${list}" -D "LABEL=${label}" -D "ENVIRONMENT=${environment}"
            -D "FOLDER=${CMAKE_CURRENT_BINARY_DIR}" -P "${PROJECT_SOURCE_DIR}/cmake/list_test_suites.cmake" VERBATIM)
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake"
       CONTENT "if(EXISTS \"${list}\")\n  include(\"${list}\")\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake")
endfunction()

# fretwork_add_bench(<stage> LINK targets..): the Google Benchmark program <stage>_bench.
function(fretwork_add_bench stage)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  add_executable(${stage}_bench ${stage}_bench.cpp)
  target_link_libraries(${stage}_bench PRIVATE ${ARG_LINK} benchmark::benchmark_main fretwork_flags)
  target_compile_definitions(${stage}_bench PRIVATE FRETWORK_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
endfunction()
