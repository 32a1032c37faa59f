// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/input_file.hpp"
#include "fuzz/promises.hpp"
#include "fuzz/readers.hpp"

#include <fretwork/outlines/flat_mesh.hpp>
#include <fretwork/outlines/outline.hpp>

namespace fretwork::fuzz {
namespace {

/// What comes out of a drawing is an outline, as those in files of our own are.
void read_drawing(const std::string& name, std::string_view bytes) {
    for (const outlines::Outline& part : outlines::read_outline_file(input_file(name, bytes)).parts)
        promise_round_trip(
            outlines::outline_text(part),
            [](std::string_view text) { return outlines::parse_outline(text, "outline"); },
            outlines::outline_text);
}

/// A mesh is read as an outline, and as a surface in space that a design is to take.
void read_mesh(const std::string& name, std::string_view bytes) {
    (void)outlines::read_space_mesh(input_file(name, bytes));
    read_drawing(name, bytes);
}

}  // namespace

void read_svg(std::string_view bytes) {
    read_drawing("input.svg", bytes);
}

void read_dxf(std::string_view bytes) {
    read_drawing("input.dxf", bytes);
}

void read_obj(std::string_view bytes) {
    read_mesh("input.obj", bytes);
}

void read_ply(std::string_view bytes) {
    read_mesh("input.ply", bytes);
}

void read_off(std::string_view bytes) {
    read_mesh("input.off", bytes);
}

void read_outline(std::string_view bytes) {
    promise_round_trip(
        bytes, [](std::string_view text) { return outlines::parse_outline(text, "outline"); },
        outlines::outline_text);
}

}  // namespace fretwork::fuzz
