// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines, and the files that they come from.
#include "core/bind.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/outlines/coloured_drawing.hpp>
#include <fretwork/outlines/flat_mesh.hpp>
#include <fretwork/outlines/outline.hpp>

namespace fretwork::python {
namespace {

using namespace outlines;

void bind_outline(py::module_& m) {
    Record<Outline>(m, "Outline", "A flat shape: a simple boundary with holes inside it.")
        .constant("boundary", &Outline::boundary, "n x 2 floats, m, counterclockwise")
        .constant("holes", &Outline::holes, "arrays of n x 2 floats, clockwise")
        .done(Made::ByFunctions);
    m.def("make_outline", &make_outline, "boundary"_a, "holes"_a = std::vector<geometry::Polygon>{},
          "Check and orient an outline (n x 2 floats, m). Raises GeometryError that names two sides that "
          "cross.\n\n>>> import fretwork as fw\n>>> square = fw.make_outline([[0, 0], [0.2, 0], [0.2, 0.2], "
          "[0, 0.2]])\n>>> print(f'{fw.area_of(square):.3f}')\n0.040\n");
    m.def("area_of", &area_of, "outline"_a, "The area without the holes, m^2.");
    bind_files<Outline>(m, "outline", {&parse_outline, &outline_text, &read_outline, &write_outline});
}

void bind_outline_files(py::module_& m) {
    Record<OutlineFile>(m, "OutlineFile",
                        "The outlines of a file, with remarks about the changes that reading them needed.")
        .constant("parts", &OutlineFile::parts, "the largest first")
        .constant("remarks", &OutlineFile::remarks, "remarks, each in a few words")
        .done(Made::ByFunctions);
    m.def("read_outline_file", &read_outline_file, "path"_a,
          "Read all outlines of an SVG, DXF, OBJ, PLY, OFF or JSON file.");
    m.def("take_parts", &take_parts, "file"_a, "which"_a,
          "Select parts of a file: 'largest', 'all', or a number from 1.");
    m.def("scaled_to_width", &scaled_to_width, "file"_a, "width"_a,
          "Scale all parts by one factor to a common width, m.");
    m.def(
        "size_text",
        [](const std::vector<Outline>& parts) {
            if (parts.empty()) throw base::InputError("parts has no outline, and so no size");
            return size_text(parts);
        },
        "parts"_a, "The width and height of the box around outlines, as a text for people.");
    Record<MeshFile>(m, "MeshFile", "The content of a mesh file.")
        .constant("points", &MeshFile::points, "n x 3 floats")
        .constant("faces", &MeshFile::faces, "lists of at least three indices into points")
        .done(Made::ByFunctions);
    m.def("read_flat_mesh", &read_flat_mesh, "path"_a, "Read a flat mesh (OBJ, PLY, OFF).");
    m.def("parse_colour", &parse_colour, "text"_a, "The colour, as '#rrggbb', of a CSS colour.");
    py::class_<ColouredDrawing>(m, "ColouredDrawing", "The filled areas of an SVG, by colour.")
        .def(py::init<const std::filesystem::path&>(), "path"_a)
        .def("colours", &ColouredDrawing::colours,
             "The colours in use, '#rrggbb', in the order in which they are painted.")
        .def("colour_at", &ColouredDrawing::colour_at, "point"_a,
             "The visible colour at a point (m); None if nothing is filled there.");
}

}  // namespace

void bind_outlines(py::module_& m) {
    bind_outline(m);
    bind_outline_files(m);
}

}  // namespace fretwork::python
