# SPDX-License-Identifier: GPL-3.0-or-later
# Text files that a library carries inside itself, so that it works wherever it is installed.

# fretwork_embed_text(<target> <variable> FILES a.json..)
# Gives the sources of <target> the header <fretwork/STAGE/detail/VARIABLE.hpp>, STAGE being the folder's name, with
#     namespace fretwork { extern const std::array<std::pair<std::string_view, std::string_view>, N> <variable>; }
# one row for each file: its name without ending, and its text. It is written when the build is configured, and again
# when a file changes.
function(fretwork_embed_text target variable)
  cmake_parse_arguments(ARG "" "" "FILES" ${ARGN})
  set(rows "")
  foreach(file IN LISTS ARG_FILES)
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" NORMALIZE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    cmake_path(GET file STEM name)
    file(READ "${file}" text)
    string(APPEND rows "    std::pair<std::string_view, std::string_view>{\"${name}\", R\"__(${text})__\"},\n")
  endforeach()
  list(LENGTH ARG_FILES count)
  set(type "std::array<std::pair<std::string_view, std::string_view>, ${count}>")
  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME stage)
  set(root "${CMAKE_CURRENT_BINARY_DIR}/generated")
  set(folder "${root}/fretwork/${stage}/detail")
  _fretwork_write_if_different("${folder}/${variable}.hpp"
"#pragma once
#include <array>
#include <string_view>
#include <utility>
namespace fretwork {
extern const ${type} ${variable};
}
")
  _fretwork_write_if_different("${folder}/${variable}.cpp"
"#include <fretwork/${stage}/detail/${variable}.hpp>
namespace fretwork {
const ${type} ${variable} = {
${rows}};
}
")
  target_sources(${target} PRIVATE "${folder}/${variable}.cpp")
  target_include_directories(${target} PRIVATE "${root}")
endfunction()

# An unchanged file keeps its time, so that nothing is compiled again.
function(_fretwork_write_if_different path content)
  set(present "")
  if(EXISTS "${path}")
    file(READ "${path}" present)
  endif()
  if(NOT present STREQUAL content)
    file(WRITE "${path}" "${content}")
  endif()
endfunction()
