// SPDX-License-Identifier: GPL-3.0-or-later
// Tessellations, how they are made, and how they are painted.
#include "core/bind.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/tiling/painting/field.hpp>
#include <fretwork/tiling/painting/graded_painting.hpp>
#include <fretwork/tiling/painting/painting.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>
#include <fretwork/tiling/tessellate.hpp>
#include <fretwork/tiling/tessellation.hpp>
#include <fretwork/tiling/tessellation_fan.hpp>

namespace fretwork::python {
namespace {

using namespace tiling;

TileIndex tile_of(const Tessellation& tessellation, int tile) {
    return TileIndex(checked_index(tile, tessellation.tiles.size(), "tile"));
}

const std::vector<TileIndex>& checked(const Tessellation& tessellation, const std::vector<TileIndex>& tiles) {
    for (const TileIndex tile : tiles) (void)tile_of(tessellation, tile);
    return tiles;
}

void bind_tessellation(py::module_& m) {
    Record<Tile>(m, "Tile", "A convex polygon of the tessellation.")
        .constant("vertices", &Tile::vertices,
                  "numbers of the vertices, counterclockwise; the first is vertex 0 of the pattern")
        .constant("interface_nodes", &Tile::interface_nodes, "numbers of the interface nodes, side by side")
        .constant("pattern", &Tile::pattern, "index into Tessellation.patterns; -1: not painted")
        .done(Made::ByFunctions);
    Record<Tessellation>(
        m, "Tessellation",
        "A flat surface of polygons that share interface nodes, each painted with a pattern.")
        .constant("layout", &Tessellation::layout, "name of the node layout")
        .constant("vertices", &Tessellation::vertices, "n x 2 floats, m")
        .constant("tiles", &Tessellation::tiles, "")
        .constant("interface_nodes", &Tessellation::interface_nodes, "n x 2 floats, m: positions")
        .constant("patterns", &Tessellation::patterns, "the palette in use")
        .done(Made::ByFunctions)
        .def("__len__", [](const Tessellation& self) { return self.tiles.size(); })
        .def(
            "pattern_of",
            [](const Tessellation& self, int tile) -> std::optional<pattern::NamedPattern> {
                const auto* found = pattern_of(self, tile_of(self, tile));
                return found == nullptr ? std::nullopt : std::optional(*found);
            },
            "tile"_a, "The pattern of a tile; None if it is not painted.")
        .def(
            "tile_polygon",
            [](const Tessellation& self, int tile) { return tile_polygon(self, tile_of(self, tile)); },
            "tile"_a, "n x 2 floats, m")
        .def_property_readonly(
            "tile_centers", [](const Tessellation& self) { return tile_centers(self); },
            "n x 2 floats, m: the centroid of each tile")
        .def_property_readonly("mean_tile_side", &mean_tile_side, "m")
        .def_property_readonly("rim_loops", &rim_loops,
                               "The numbers of the interface nodes along each line of the rim.")
        .def("__repr__", [](const Tessellation& self) {
            return "<Tessellation: " + std::to_string(self.tiles.size()) + " tiles, " +
                   std::to_string(self.interface_nodes.size()) + " interface nodes, " +
                   std::to_string(self.patterns.size()) + " patterns>";
        });
    m.def("validate", py::overload_cast<const Tessellation&, const pattern::NodeLayout&>(&tiling::validate),
          "tessellation"_a, "layout"_a, "Check that a tessellation is valid. Raises InputError.");
}

void bind_tessellate(py::module_& m) {
    bind_enum<Narrow>(m);
    Record<TessellationOptions>(m, "TessellationOptions", "Options of tessellate().")
        .field("edge_length", &TessellationOptions::edge_length, "wanted mean side of the polygons, m")
        .field("smallest_side", &TessellationOptions::smallest_side, "m; 0: no limit")
        .field("narrow", &TessellationOptions::narrow, "")
        .field("remeshing_iterations", &TessellationOptions::remeshing_iterations, "")
        .field("relaxation_iterations", &TessellationOptions::relaxation_iterations, "")
        .field("lattice_angles", &TessellationOptions::lattice_angles, "number of triangular lattices to try")
        .field("angle", &TessellationOptions::angle,
               "angle of the rows of tiles, rad; None: the best of several")
        .field("threads", &TessellationOptions::threads,
               "number of threads; 0: one for each processor; the result does not depend on the number")
        .done();
    Record<TessellationReport>(m, "TessellationReport", "The measures of a tiling.")
        .constant("mean_side", &TessellationReport::mean_side, "m")
        .constant("sd_side", &TessellationReport::sd_side, "m")
        .constant("smallest_side", &TessellationReport::smallest_side, "m")
        .constant("largest_side", &TessellationReport::largest_side, "m")
        .constant("smallest_angle", &TessellationReport::smallest_angle, "rad")
        .constant("hexagon_share", &TessellationReport::hexagon_share, "of the tiles")
        .constant("inner_hexagon_share", &TessellationReport::inner_hexagon_share,
                  "share of hexagons among the tiles without a vertex on the outline")
        .constant("covered_share", &TessellationReport::covered_share,
                  "share of the outline's area that tiles cover")
        .constant("outside_share", &TessellationReport::outside_share, "")
        .constant("refined_share", &TessellationReport::refined_share, "of the tiles")
        .constant("tiles", &TessellationReport::tiles, "")
        .constant("inner_tiles", &TessellationReport::inner_tiles,
                  "number of tiles without a vertex on the outline")
        .constant("negligible_points", &TessellationReport::negligible_points, "")
        .constant("start", &TessellationReport::start, "'remeshing', or 'lattice at 15 deg'")
        .done(Made::ByFunctions);
    Record<TessellationResult>(m, "TessellationResult", "The outcome of tessellate().")
        .constant("tessellation", &TessellationResult::tessellation, "")
        .constant("report", &TessellationResult::report, "")
        .done(Made::ByFunctions);
    m.def(
        "tessellate",
        [](const std::variant<outlines::Outline, std::vector<outlines::Outline>>& outline,
           const pattern::NodeLayout& layout, const py::kwargs& named) {
            const auto* one = std::get_if<outlines::Outline>(&outline);
            const auto parts = one != nullptr ? std::vector{*one} : std::get<1>(outline);
            return Keywords<TessellationOptions>(named).run(
                [&](const auto& options) { return tessellate_parts(parts, layout, options); });
        },
        "outline"_a, "layout"_a,
        "Cover an outline, or several separate outlines, with convex polygons that share whole "
        "sides.\n\nOptions: TessellationOptions, progress\n\n>>> import fretwork as fw\n>>> square = "
        "fw.make_outline([[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]])\n>>> fw.tessellate(square, "
        "fw.paper_layout(), edge_length=0.025).report.tiles\n33\n");
    m.def("read_mesh_tessellation", &read_mesh_tessellation, "path"_a, "layout"_a,
          "Take the faces of a flat OBJ, PLY or OFF mesh as tiles.");
}

void bind_fans(py::module_& m) {
    Record<TessellationFan::Edge>(m, "TessellationEdge", "An edge of the patterns of all tiles.")
        .constant("nodes", &TessellationFan::Edge::nodes, "two numbers")
        .constant("tile", &TessellationFan::Edge::tile, "")
        .done(Made::ByFunctions);
    Record<TessellationFan>(m, "TessellationFan", "The patterns of all tiles as one graph in the plane.")
        .constant("interface_node_count", &TessellationFan::interface_node_count,
                  "number of interface nodes, which are the first nodes")
        .constant("nodes", &TessellationFan::nodes, "n x 2 floats, m")
        .constant("edges", &TessellationFan::edges, "")
        .constant("tile_nodes", &TessellationFan::tile_nodes, "for each tile, the nodes of its fan")
        .constant("first_edge", &TessellationFan::first_edge,
                  "for each tile, the index of its first edge, followed by the number of edges")
        .done(Made::ByFunctions);
    m.def("assemble_fans", &assemble_fans, "layout"_a, "tessellation"_a,
          "Repeat every tile's pattern around its polygon.");
}

void bind_paintings(py::module_& m) {
    bind_enum<Dithering>(m);
    Record<Painting>(m, "Painting", "The patterns in use, and the pattern of each tile.")
        .field("patterns", &Painting::patterns, "")
        .field("tiles", &Painting::tiles,
               "for each tile, the index of its pattern in `patterns`; empty: a palette")
        .done();
    Record<GradedPattern>(m, "GradedPattern", "A pattern with the value of a quantity, such as its mass.")
        .field("pattern", &GradedPattern::pattern, "")
        .field("value", &GradedPattern::value, "")
        .done();
    Record<WeightedPattern>(m, "WeightedPattern", "A pattern with its weight in a random choice.")
        .field("pattern", &WeightedPattern::pattern, "")
        .field("weight", &WeightedPattern::weight, "")
        .done();
    m.def(
        "make_palette",
        [](const pattern::NodeLayout& layout, const std::vector<std::string>& ids) {
            return make_palette(layout, ids);
        },
        "layout"_a, "ids"_a,
        "The patterns with these ids, checked for use in a painting. Raises InputError.");
    m.def(
        "random_painting",
        [](std::size_t tiles, const std::vector<WeightedPattern>& patterns, std::uint64_t seed) {
            return random_painting(tiles, patterns, seed);
        },
        "tiles"_a, "patterns"_a, "seed"_a,
        "A random painting; the same seed gives the same painting on every machine.");
    m.def(
        "graded_painting",
        [](const Tessellation& tessellation, const std::vector<TileIndex>& tiles,
           const std::vector<GradedPattern>& patterns, const std::vector<double>& wanted,
           Dithering dithering) {
            return graded_painting(tessellation, checked(tessellation, tiles), patterns, wanted, dithering);
        },
        "tessellation"_a, "tiles"_a, "patterns"_a, "wanted"_a, "dithering"_a = Dithering::None,
        "Paint tiles with the patterns whose values are nearest to the wanted values.");
    m.def("parse_painting", &parse_painting, "text"_a, "source"_a, "layout"_a);
    m.def("painting_text", &painting_text, "painting"_a, "layout"_a);
    m.def("read_painting", &read_painting, "path"_a, "layout"_a);
    m.def("write_painting", &write_painting, "painting"_a, "layout"_a, "path"_a);
}

void bind_choices(py::module_& m) {
    Record<geometry::Box>(m, "Box", "A box with sides parallel to the axes.")
        .field("xmin", &geometry::Box::xmin, "m")
        .field("ymin", &geometry::Box::ymin, "m")
        .field("xmax", &geometry::Box::xmax, "m")
        .field("ymax", &geometry::Box::ymax, "m")
        .done();
    Record<geometry::Circle>(m, "Circle", "A circle with its inside.")
        .field("center", &geometry::Circle::center, "x y, m")
        .field("radius", &geometry::Circle::radius, "m")
        .done();
    m.def("bounding_box", &bounding_box, "tessellation"_a);
    m.def("parse_tiles", &parse_tiles, "text"_a, "tessellation"_a,
          "The tiles in a list of numbers and ranges: '3,7-11'.");
    m.def("tiles_in", py::overload_cast<const geometry::Box&, const Tessellation&>(&tiles_in), "box"_a,
          "tessellation"_a, "The tiles whose centroid lies in a box.");
    m.def("tiles_in", py::overload_cast<const geometry::Circle&, const Tessellation&>(&tiles_in), "circle"_a,
          "tessellation"_a, "The tiles whose centroid lies in a circle.");
    m.def("tiles_in", py::overload_cast<const geometry::Polygon&, const Tessellation&>(&tiles_in),
          "polygon"_a, "tessellation"_a, "The tiles whose centroid lies in a polygon (n x 2, m).");
    m.def("expression_values", &expression_values, "expression"_a, "box"_a, "points"_a,
          "The values of an expression of x, y (m) and u, v (0 to 1 across the box) at points (n x 2).");
    m.def("image_values",
          py::overload_cast<const std::filesystem::path&, const geometry::Box&,
                            const std::vector<geometry::Point2>&>(&image_values),
          "image"_a, "box"_a, "points"_a, "The darkness of a PNG image: 0 is white, 1 is black.");
}

}  // namespace

void bind_tessellations(py::module_& m) {
    bind_tessellation(m);
    bind_tessellate(m);
    bind_fans(m);
    bind_paintings(m);
    bind_choices(m);
}

}  // namespace fretwork::python
