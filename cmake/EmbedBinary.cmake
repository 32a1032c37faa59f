# SPDX-License-Identifier: GPL-3.0-or-later
# Binary files that a library carries inside itself. Texts: EmbedText.cmake.

# fretwork_embed_binary(<target> <name> FILE <path>)
# Gives the sources of <target> the header <fretwork/STAGE/detail/NAME.hpp>, STAGE being the folder's name, with
#     namespace fretwork { std::span<const unsigned char> NAME(); }
# The assembler reads the file, so that even a large one costs no compilation.
function(fretwork_embed_binary target name)
  cmake_parse_arguments(ARG "" "FILE" "" ${ARGN})
  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME stage)
  set(root "${CMAKE_CURRENT_BINARY_DIR}/generated")
  set(folder "${root}/fretwork/${stage}/detail")
  _fretwork_write_if_different("${folder}/${name}.hpp"
"#pragma once
#include <span>
namespace fretwork {
std::span<const unsigned char> ${name}();
}
")
  _fretwork_write_if_different("${folder}/${name}.cpp"
"#include <fretwork/${stage}/detail/${name}.hpp>
asm(R\"(
.pushsection .rodata
.balign 16
.hidden fretwork_${name}_begin
.globl fretwork_${name}_begin
fretwork_${name}_begin:
.incbin \"${ARG_FILE}\"
.hidden fretwork_${name}_end
.globl fretwork_${name}_end
fretwork_${name}_end:
.popsection
)\");
extern \"C\" {
__attribute__((visibility(\"hidden\"))) extern const unsigned char fretwork_${name}_begin[];
__attribute__((visibility(\"hidden\"))) extern const unsigned char fretwork_${name}_end[];
}
namespace fretwork {
std::span<const unsigned char> ${name}() {
    return {fretwork_${name}_begin, fretwork_${name}_end};
}
}
")
  target_sources(${target} PRIVATE "${folder}/${name}.cpp")
  set_source_files_properties("${folder}/${name}.cpp" PROPERTIES
    OBJECT_DEPENDS "${ARG_FILE}" SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
  target_include_directories(${target} PRIVATE "${root}")
endfunction()
