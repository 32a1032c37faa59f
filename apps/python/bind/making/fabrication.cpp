// SPDX-License-Identifier: GPL-3.0-or-later
// What is made of a surface: true outlines, solids, sheets, facts.
#include "core/bind.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/exports/making/making_files.hpp>
#include <fretwork/fabrication/bar_plan.hpp>
#include <fretwork/fabrication/facts.hpp>
#include <fretwork/fabrication/shape.hpp>
#include <fretwork/fabrication/sheets.hpp>
#include <fretwork/fabrication/solid.hpp>

namespace fretwork::python {
namespace {

using namespace fabrication;

/// A contour as rows of x, y, bulge.
using ContourRows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
ContourRows rows_of(const Contour& contour) {
    ContourRows rows(std::ssize(contour), 3);
    for (Eigen::Index p = 0; p < rows.rows(); ++p) {
        const ContourPoint& point = contour[static_cast<std::size_t>(p)];
        rows.row(p) << point.place.x, point.place.y, point.bulge;
    }
    return rows;
}

std::vector<ContourRows> rows_of(const std::vector<Contour>& contours) {
    std::vector<ContourRows> all;
    for (const Contour& contour : contours) all.push_back(rows_of(contour));
    return all;
}

/// Places for bolts must be nodes of the surface.
void check_bolts(const simulation::Surface& surface, const ShapeOptions& options) {
    if (options.bolts.empty()) return;
    const std::size_t nodes = simulation::surface_fan(surface).nodes.size();
    for (const auto node : options.bolts) checked_index(node.value, nodes, "node");
}

void bind_shape(py::module_& m) {
    py::class_<Piece>(m, "Piece", "Material in one piece. The material lies on the left of the contours.")
        .def_property_readonly(
            "outer", [](const Piece& self) { return rows_of(self.outer); },
            "n x 3 floats: x, y (m), and the bulge of the arc to the next point; 0: straight")
        .def_property_readonly(
            "openings", [](const Piece& self) { return rows_of(self.openings); }, "the same");
    py::class_<Shape>(m, "Shape",
                      "The true outline of a surface: bars with their width, merged where they meet.")
        .def_property_readonly(
            "pieces", [](const Shape& self) { return self.pieces; }, "pieces from left to right")
        .def_property_readonly(
            "height", [](const Shape& self) { return self.height; }, "m")
        .def_property_readonly(
            "area", [](const Shape& self) { return area(self); }, "m2")
        .def_property_readonly("cut_length", &cut_length, "m")
        .def_property_readonly("opening_count", &opening_count)
        .def_property_readonly(
            "box",
            [](const Shape& self) {
                const geometry::Box box = box_of(self);
                return std::array{box.xmin, box.ymin, box.xmax, box.ymax};
            },
            "xmin ymin xmax ymax, m");
    Record<ShapeOptions>(m, "ShapeOptions",
                         "Options of the true outline, and material in addition to the bars.")
        .field("fillet", &ShapeOptions::fillet, "radius of inner corners, m; 0: sharp")
        .field("kerf", &ShapeOptions::kerf, "width that the cutter removes, m")
        .field("frame_width", &ShapeOptions::frame_width, "width of bars along the rim, m; 0: none")
        .field("bolt_diameter", &ShapeOptions::bolt_diameter, "diameter of holes at `bolts`, m; 0: none")
        .field("eye_diameter", &ShapeOptions::eye_diameter,
               "diameter of the discs around holes, m; 0: twice the diameter of the holes")
        .field("bolts", &ShapeOptions::bolts, "numbers of the nodes with a hole")
        .done();
    m.def(
        "make_shape",
        [](const simulation::Surface& surface, const py::kwargs& named) {
            Keywords<ShapeOptions> keywords(named);
            check_bolts(surface, keywords.options);
            return keywords.run([&](const auto& options) { return make_shape(surface, options); });
        },
        "surface"_a, "The true outline of a surface's bars.\n\nOptions: ShapeOptions, progress\n");
    m.def(
        "shape_remarks",
        [](const simulation::Surface& surface, const py::kwargs& named) {
            Keywords<ShapeOptions> keywords(named);
            check_bolts(surface, keywords.options);
            return keywords.run(
                [&](const auto& options) { return make_remarked_shape(surface, options).remarks; });
        },
        "surface"_a,
        "Remarks about options that could not be met everywhere.\n\nOptions: ShapeOptions, progress\n");
}

void bind_solid(py::module_& m) {
    py::class_<Solid>(m, "Solid", "A closed surface of triangles, counterclockwise seen from outside.")
        .def_property_readonly(
            "vertices", [](const Solid& self) { return self.vertices; }, "n x 3 floats, m")
        .def_property_readonly(
            "triangles",
            [](const Solid& self) {
                Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor> rows(std::ssize(self.triangles), 3);
                for (Eigen::Index t = 0; t < rows.rows(); ++t)
                    for (Eigen::Index c = 0; c < 3; ++c)
                        rows(t, c) = self.triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(c)];
                return rows;
            },
            "n x 3 ints")
        .def_property_readonly("volume", &volume, "m3")
        .def_property_readonly("open_edges", [](const Solid& self) { return check(self).open_edges; })
        .def_property_readonly("euler_number", [](const Solid& self) { return check(self).euler_number; });
    m.def(
        "make_solid",
        [](const Shape& shape, double chord_tolerance, const py::object& progress) {
            return run_long(progress, [&](const base::Control& control) {
                return make_solid(shape, {.chord_tolerance = chord_tolerance, .control = control});
            });
        },
        "shape"_a, "chord_tolerance"_a = SolidOptions{}.chord_tolerance, "progress"_a = py::none(),
        "A shape extruded from z = 0 to its height.");
}

void bind_sheets(py::module_& m) {
    Record<Bed>(m, "Bed", "Options of sheets: the bed of the cutter, and the fit of the parts.")
        .field("width", &Bed::width, "m")
        .field("height", &Bed::height, "m")
        .field("margin", &Bed::margin, "margin along the edges of the bed, m")
        .field("spacing", &Bed::spacing, "distance between parts, m")
        .field("fit", &Bed::fit, "gap between the two sides of a connector, m")
        .done();
    py::class_<CutSheet>(m, "CutSheet", "The input of a cutter: one sheet of material.")
        .def_property_readonly("title", [](const CutSheet& self) { return self.title; })
        .def_property_readonly("pieces", [](const CutSheet& self) { return self.pieces; });
    py::class_<SheetSet>(m, "SheetSet", "A surface in parts that fit a bed, nested on sheets.")
        .def_property_readonly("sheets", [](const SheetSet& self) { return self.sheets; })
        .def_property_readonly("assembly", [](const SheetSet& self) { return self.assembly; })
        .def_property_readonly("parts", [](const SheetSet& self) { return self.parts; })
        .def_property_readonly("connectors", [](const SheetSet& self) { return self.connectors; })
        .def_property_readonly("remarks", [](const SheetSet& self) { return self.remarks; });
    m.def(
        "cut_into_sheets",
        [](const simulation::Surface& surface, const Bed& bed, const py::kwargs& named) {
            Keywords<ShapeOptions> keywords(named);
            check_bolts(surface, keywords.options);
            return keywords.run([&](const auto& options) { return cut_into_sheets(surface, options, bed); });
        },
        "surface"_a, "bed"_a,
        "Cut a surface into parts that fit a bed.\n\nOptions: ShapeOptions, progress\n");
}

void bind_facts(py::module_& m) {
    Record<FactsOptions>(m, "FactsOptions", "The limits of a machine and a material.")
        .field("clearance", &FactsOptions::clearance,
               "width, m, below which gaps and openings cause a warning")
        .field("layer_height", &FactsOptions::layer_height, "m, of a print")
        .field("sharp_angle", &FactsOptions::sharp_angle,
               "angle between bars, rad, below which there is a warning")
        .field("strength", &FactsOptions::strength,
               "stress, Pa, above which there is a warning; None: the material's strength")
        .field("bed", &FactsOptions::bed, "bed for whose parts openings are counted; None: one piece")
        .done();
    Record<Warning>(m, "FactsWarning", "A warning for the maker.")
        .constant("message", &Warning::message, "one line")
        .constant("place", &Warning::place, "m; None if it is about the whole surface")
        .done(Made::ByFunctions);
    Record<Facts>(m, "Facts", "The facts that a maker needs before making a surface. SI.")
        .constant("tiles", &Facts::tiles, "")
        .constant("bars", &Facts::bars, "")
        .constant("pieces", &Facts::pieces, "")
        .constant("openings", &Facts::openings, "")
        .constant("height", &Facts::height, "m")
        .constant("area", &Facts::area, "area of the true outline, m^2")
        .constant("volume", &Facts::volume, "m3")
        .constant("mass", &Facts::mass, "mass, kg; 0 if the material has no density")
        .constant("beam_mass", &Facts::beam_mass, "mass of the model's beams, kg")
        .constant("cut_length", &Facts::cut_length, "m")
        .constant("pierces", &Facts::pierces, "number of contours, each of which a cutter starts separately")
        .constant("layers", &Facts::layers, "of a print")
        .constant("wall_length", &Facts::wall_length, "length of the contours of all layers, m")
        .constant("sharpest_angle", &Facts::sharpest_angle, "smallest angle between the bars of a node, rad")
        .constant("smallest_radius", &Facts::smallest_radius, "smallest radius of inner corners, m; 0: sharp")
        .constant("strength", &Facts::strength, "Pa, or None")
        .constant("warnings", &Facts::warnings, "")
        .done(Made::ByFunctions)
        .def_property_readonly(
            "text", [](const Facts& self) { return exports::facts_text(self); },
            "The facts as a table for people, with sag, stress and warnings.")
        .def_property_readonly(
            "json", [](const Facts& self) { return exports::facts_json(self); }, "'fretwork/facts/3'");
    m.def(
        "facts",
        [](const simulation::Surface& surface, const ShapeOptions& shape,
           const std::optional<simulation::LoadCase>& load_case, const py::kwargs& named) {
            check_bolts(surface, shape);
            Keywords<FactsOptions> keywords(named);
            return keywords.run([&](const auto& options) {
                ShapeOptions controlled = shape;
                controlled.control = options.control.silent();
                return facts(surface, controlled, {load_case ? &*load_case : nullptr, nullptr}, options);
            });
        },
        "surface"_a, "shape"_a = ShapeOptions{}, "load_case"_a = py::none(),
        "The facts that a maker needs; with a load case, also sag and stress.\n\nOptions: FactsOptions, "
        "progress\n");
}

}  // namespace

void bind_fabrication(py::module_& m) {
    bind_shape(m);
    bind_solid(m);
    bind_sheets(m);
    bind_facts(m);
}

}  // namespace fretwork::python
