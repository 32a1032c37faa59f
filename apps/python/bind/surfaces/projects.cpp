// SPDX-License-Identifier: GPL-3.0-or-later
// Projects, how they are made and painted, and surfaces.
#include "core/bind.hpp"
#include "reduction/library_object.hpp"
#include "surfaces/painting_choices.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/project/new_project.hpp>
#include <fretwork/simulation/project/painting_choice.hpp>
#include <fretwork/simulation/project/painting_recipe.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/simulation/project/retiling.hpp>
#include <fretwork/simulation/surface.hpp>
#include <fretwork/tiling/painting/painting.hpp>
#include <fretwork/tiling/tessellation.hpp>

namespace fretwork::python {
namespace {

using namespace simulation;
using tiling::TileIndex;
using Tiles = std::vector<TileIndex>;

void bind_painting_choices(py::module_& m) {
    Record<PaletteChoice>(m, "PaletteChoice", "The patterns that a painting chooses from.")
        .field("ids", &PaletteChoice::ids, "")
        .field("file", &PaletteChoice::file, "a painting file; used if no ids are given")
        .done();
    Record<PaintOnePattern>(m, "PaintOnePattern", "All tiles have one pattern.")
        .field("id", &PaintOnePattern::id, "")
        .done();
    Record<PaintFromFile>(m, "PaintFromFile", "Paint by a painting file.")
        .field("file", &PaintFromFile::file, "")
        .done();
    Record<PaintAtRandom>(m, "PaintAtRandom", "By chance.")
        .field("seed", &PaintAtRandom::seed, "")
        .field("palette", &PaintAtRandom::palette, "")
        .field("weights", &PaintAtRandom::weights, "of the palette's ids; empty: all are equally likely")
        .done();
    Record<FieldExpression>(m, "FieldExpression",
                            "A number over the surface, as an expression of x, y (m) and u, v (0 to 1).")
        .field("text", &FieldExpression::text, "")
        .done();
    Record<FieldImage>(m, "FieldImage", "The darkness of a PNG image that is stretched over the surface.")
        .field("file", &FieldImage::file, "with a content, its name in messages")
        .field("content", &FieldImage::content, "bytes of the file; None: it is read from `file`")
        .done();
    Record<PaintByField>(m, "PaintByField", "Paint along a palette, by a field that goes from 0 to 1.")
        .field("field", &PaintByField::field, "")
        .field("palette", &PaintByField::palette, "")
        .field("property", &PaintByField::property,
               "property of patterns; empty: the palette's order decides")
        .field("range", &PaintByField::range, "values of the property for fields of 0 and 1")
        .field("dithering", &PaintByField::dithering, "")
        .done();
    Record<PaintByColours>(m, "PaintByColours", "Paint by the colour of a drawing at each tile.")
        .field("drawing", &PaintByColours::drawing, "SVG; with a content, its name in messages")
        .field("palette", &PaintByColours::palette, "colours '#rrggbb', each with an id")
        .field("content", &PaintByColours::content, "bytes of the drawing; None: it is read from `drawing`")
        .done();
}

void bind_recipes(py::module_& m) {
    Record<PaintingRecipe>(m, "PaintingRecipe",
                           "A choice by a field, by colours or at random, and the tiles that it has painted. "
                           "It needs no file.")
        .field("choice", &PaintingRecipe::choice, "")
        .field("tiles", &PaintingRecipe::tiles, "")
        .done();
}

Tiles tiles_or_all(const tiling::Tessellation& tessellation, const std::optional<Tiles>& tiles) {
    const auto count = tessellation.tiles.size();
    if (!tiles) return Tiles(tessellation.tiles.indices().begin(), tessellation.tiles.indices().end());
    for (const TileIndex tile : *tiles) checked_index(tile.value, count, "tile");
    return *tiles;
}

/// Paints some tiles of a project, None: all, and returns those that were painted.
Tiles paint_project(Project& project, const PaintingGiven& given, const std::optional<Tiles>& tiles,
                    const LibraryPointer& library, const py::kwargs& named) {
    py::dict others(named.attr("copy")());
    const PaintingChoice choice = painting_choice(given, others);
    if (!others.empty())
        throw py::type_error("paint() does not take " + py::cast<std::string>(py::str(py::list(others))));
    return with_library(library, [&](const library::Library* opened) {
        return paint(project, tiles_or_all(project.tessellation, tiles), choice, opened);
    });
}

void bind_project(py::module_& m) {
    Record<Project> project(
        m, "Project",
        "The one document that the command line and the studio share: outline, tessellation, "
        "painting, setting and load cases.\n\n"
        ">>> import fretwork as fw\n"
        ">>> square = fw.make_outline([[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]])\n"
        ">>> project, report = fw.make_project(square, patterns='0-1+1-6', edge_length=0.025)\n"
        ">>> len(project.tessellation) == report.tiles\n"
        "True\n");
    Record<Project::TileModelChoice>(project.type(), "TileModelChoice",
                                     "Some tiles with a tile model of their own.")
        .field("model", &Project::TileModelChoice::model, "name of a row of the catalogue")
        .field("tiles", &Project::TileModelChoice::tiles, "")
        .done();
    project.constant("layout", &Project::layout, "of the tessellation's patterns")
        .constant("outline", &Project::outline, "")
        .constant("further_outlines", &Project::further_outlines,
                  "further parts of a surface with several parts")
        .constant("tessellation", &Project::tessellation, "tessellation with its painting")
        .field("load_cases", &Project::load_cases, "")
        .field("setting", &Project::setting,
               "setting, as a copy; None: the setting of the library, or the paper's setting")
        .field("tile_models", &Project::tile_models, "")
        .constant("recipes", &Project::recipes,
                  "how tiles were painted by place or by chance, which retile() applies again")
        .field("library_path", &Project::library_path, "library, relative to the project file; empty: none")
        .field("library_hash", &Project::library_hash, "")
        .done(Made::ByFunctions)
        .def("__repr__", [](const Project& self) {
            return "<Project: " + std::to_string(self.tessellation.tiles.size()) + " tiles, " +
                   std::to_string(self.load_cases.size()) + " load cases>";
        });
    project.type()
        .def("paint", &paint_project, "patterns"_a, "tiles"_a = py::none(), "library"_a = py::none(),
             "Paint tiles (None: all): with the id of a pattern, with a text as for --patterns on the "
             "command line ('random:1', 'field:u', with palette=, property=, range=, dither=), or with a "
             "Paint.. value. Returns the tiles that were painted. Project.recipes keeps the choice, "
             "unless its image or drawing has more than 4 MiB.")
        .def(
            "paint_as",
            [](Project& self, const tiling::Painting& painting) {
                (void)tiling::make_palette(self.layout, pattern::ids_of(painting.patterns));
                for (const int entry : painting.tiles)
                    if (entry != -1)
                        checked_index(entry, painting.patterns.size(), "pattern of the painting");
                paint(self.tessellation, painting);
                self.recipes.clear();
            },
            "painting"_a, "Paint every tile with the pattern that a painting gives it.")
        .def(
            "turn",
            [](Project& self, const Tiles& tiles, int vertices) {
                for (const TileIndex tile : tiles_or_all(self.tessellation, tiles))
                    tiling::turn(self.tessellation.tiles[tile], vertices);
            },
            "tiles"_a, "vertices"_a,
            "Turn the patterns of tiles: vertex 0 moves by `vertices` vertices counterclockwise.")
        .def(
            "mirror",
            [](Project& self, const Tiles& tiles) {
                const Tiles mirrored = tiles_or_all(self.tessellation, tiles);
                mirror(self.tessellation, mirrored, self.layout);
                end_recipes(self, mirrored);
            },
            "tiles"_a, "Replace the patterns of tiles by their mirror images.")
        .def(
            "end_recipes",
            [](Project& self, const std::optional<Tiles>& tiles) {
                end_recipes(self, tiles_or_all(self.tessellation, tiles));
            },
            "tiles"_a = py::none(),
            "Take tiles (None: all) out of their recipes: retile() then keeps their patterns by place.")
        .def(
            "apply_recipes",
            [](Project& self, const LibraryPointer& library) {
                with_library(library, [&](const library::Library* opened) { apply_recipes(self, opened); });
            },
            "library"_a = py::none(), "Paint the tiles of every recipe again, such as in another setting.")
        .def(
            "find_load_case",
            [](const Project& self, const std::string& name) { return find_load_case(self, name); },
            "name"_a = "",
            "The load case with a name, together with the load cases that it combines; '' means the only "
            "load case.");
    bind_files<Project>(m, "project", {&parse_project, &project_text, &read_project, &write_project});
    m.def("find_load_case", &find_load_case, "project"_a, "name"_a = "");
}

void bind_making(py::module_& m) {
    bind_enum<TilesFrom>(m);
    Record<NewProjectOptions>(m, "NewProjectOptions", "Options of make_project().")
        .field("outline_name", &NewProjectOptions::outline_name,
               "file of the outline, or of the mesh whose faces become tiles")
        .field("edge_length", &NewProjectOptions::edge_length,
               "wanted mean side of the tiles, m; None: the setting's tile side")
        .field("angle", &NewProjectOptions::angle,
               "angle of the rows of tiles, rad; None: the most regular tiling")
        .field("tiles", &NewProjectOptions::tiles, "")
        .field("narrow", &NewProjectOptions::narrow,
               "treatment of places where the outline is narrower than a tile")
        .field("layout", &NewProjectOptions::layout,
               "a name that find_node_layout() knows, or a layout file (.json); empty: the library's layout, "
               "or paper7")
        .field("own_layout", &NewProjectOptions::own_layout, "a NodeLayout of your own, in place of `layout`")
        .field("setting", &NewProjectOptions::setting,
               "material, section and joints; None: the library's setting, or made_setting(), whose joints "
               "are stiff")
        .done();
    m.def(
        "make_project",
        [](const std::variant<outlines::Outline, std::vector<outlines::Outline>>& outline,
           const PaintingGiven& patterns, const LibraryPointer& library, const py::kwargs& named) {
            const auto* one = std::get_if<outlines::Outline>(&outline);
            const auto parts = one != nullptr ? std::vector{*one} : std::get<1>(outline);
            if (parts.empty()) throw base::InputError("a project needs an outline");
            py::dict others(named.attr("copy")());
            const PaintingChoice choice = painting_choice(patterns, others);
            auto keywords = Keywords<NewProjectOptions>::rest(others);
            keywords.options.painting = choice;
            NewProject made = keywords.run([&](const auto& options) {
                return with_library(library, [&](const library::Library* opened) {
                    return make_project(parts, options, opened);
                });
            });
            return std::pair(std::move(made.project), made.report);
        },
        "outline"_a, "patterns"_a = py::none(), "library"_a = py::none(),
        "Tile an outline, or several separate outlines, and paint the tiles as Project.paint() does: "
        "`patterns` is an id, or a way of choosing ids ('random:1', with a `palette` of ids). Returns the "
        "project and a TessellationReport.\n\nOptions: NewProjectOptions, palette, property, range, dither, "
        "progress\n");
}

void bind_retiling(py::module_& m) {
    Record<RetilingOptions>(m, "RetilingOptions", "How a project gets other tiles.")
        .field("edge_length", &RetilingOptions::edge_length,
               "m, wanted mean side of the new tiles; None: that of the present tiles")
        .field("angle", &RetilingOptions::angle, "rad, of the rows of tiles; None: the most regular tiling")
        .field("narrow", &RetilingOptions::narrow, "what to do where the outline is narrower than a tile")
        .field("layout", &RetilingOptions::layout, "a NodeLayout; None: the project's")
        .done();
    Record<DroppedEntries>(m, "DroppedEntries",
                           "How many entries of load cases have no place on other tiles: those that select "
                           "interface nodes by number.")
        .constant("supports", &DroppedEntries::supports, "")
        .constant("loads", &DroppedEntries::loads, "on nodes, and on tiles from which no new tile comes")
        .constant("prescribed", &DroppedEntries::prescribed, "prescribed displacements")
        .done(Made::ByFunctions);
    Record<RetiledProject>(m, "RetiledProject", "A project on other tiles. Made by retile.")
        .constant("project", &RetiledProject::project, "")
        .constant("report", &RetiledProject::report, "measures of the new tiles")
        .constant("dropped", &RetiledProject::dropped, "entries of load cases that were left out")
        .constant("from_tiles", &RetiledProject::from,
                  "for each new tile, the number of the old tile whose centroid is nearest")
        .constant("painted", &RetiledProject::painted, "tiles that `patterns` has painted")
        .done(Made::ByFunctions);
    m.def(
        "retile",
        [](const Project& project, const PaintingGiven& patterns, const LibraryPointer& library,
           const py::kwargs& named) {
            py::dict others(named.attr("copy")());
            const PaintingChoice choice = painting_choice(patterns, others);
            auto keywords = Keywords<RetilingOptions>::rest(others);
            keywords.options.painting = choice;
            return keywords.run([&](const auto& options) {
                return with_library(library, [&](const library::Library* opened) {
                    return retile(project, options, opened);
                });
            });
        },
        "project"_a, "patterns"_a = py::none(), "library"_a = py::none(),
        "Cover the outline of a project with other tiles. Without `patterns`, a tile takes pattern and tile "
        "model of the old tile whose centroid is nearest, and the recipes of the painting are applied again; "
        "with them, it is painted as make_project does. "
        "Supports and loads stay by side, box, places and rim; those on interface nodes by number are left "
        "out, and counted. With another layout the tiles are bare without `patterns`, and the project leaves "
        "its library.\n\n"
        ">>> import fretwork as fw\n"
        ">>> square = fw.make_outline([[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]])\n"
        ">>> project, _ = fw.make_project(square, patterns='0-1+1-6', edge_length=0.025)\n"
        ">>> made = fw.retile(project, edge_length=0.015)\n"
        ">>> len(made.project.tessellation) == made.report.tiles\n"
        "True\n\n"
        "Options: RetilingOptions, palette, property, range, dither, progress\n");
}

void bind_surface(py::module_& m) {
    Record<Surface> outer(m, "Surface",
                          "A painted tessellation with its setting and calibrations, from which its tiles "
                          "are built. Made by make_surface().\n\n>>> import fretwork as fw\n>>> square = "
                          "fw.make_outline([[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]])\n>>> project, _ = "
                          "fw.make_project(square, patterns='0-1+1-6', edge_length=0.025)\n>>> surface = "
                          "fw.make_surface(project)\n>>> surface.tessellation.tiles[0].pattern\n0\n");
    outer.constant("layout", &Surface::layout, "")
        .constant("tessellation", &Surface::tessellation, "")
        .constant("setting", &Surface::setting, "material and section of the beams")
        .constant("calibrations", &Surface::calibrations,
                  "for each pattern, its best calibration of each tile model")
        .constant("tile_models", &Surface::tile_models,
                  "tile model of each tile; '': the model of the simulation");
    outer.type()
        .def_property_readonly("tile_masses", &tile_masses, "mass of each tile's beams, kg")
        .def("__copy__", [](const Surface& self) { return self; })
        .def(
            "__deepcopy__", [](const Surface& self, const py::dict&) { return self; }, "memo"_a)
        .def("__repr__",
             [](const Surface& self) {
                 return "<Surface: " + std::to_string(self.tessellation.tiles.size()) + " tiles, " +
                        std::to_string(self.tessellation.interface_nodes.size()) + " interface nodes>";
             })
        .def(py::pickle(
            [](const Surface& self) {
                return py::make_tuple(self.layout, self.tessellation, self.setting, self.calibrations,
                                      std::vector<std::string>(self.tile_models));
            },
            [](const py::tuple& state) {
                return Surface{state[0].cast<pattern::NodeLayout>(), state[1].cast<tiling::Tessellation>(),
                               state[2].cast<reduction::Setting>(),
                               state[3].cast<std::vector<std::vector<reduction::Calibration>>>(),
                               state[4].cast<std::vector<std::string>>()};
            }));
    m.def(
        "make_surface",
        [](const Project& project, const LibraryPointer& library) {
            tiling::validate(project.tessellation, project.layout);
            return with_library(
                library, [&](const library::Library* opened) { return make_surface(project, opened); });
        },
        "project"_a, "library"_a = py::none(),
        "Gather a project's surface, with the calibrations of a library.");
    m.def(
        "load_rows",
        [](const LoadCase& load_case, const Surface& surface) {
            return load_rows(resolve(load_case, surface), surface.tessellation.interface_nodes.size());
        },
        "load_case"_a, "surface"_a,
        "The forces (N) and moments (N m) on each interface node, including shares of the tiles' weight: n x "
        "6 floats.");
    m.def("surface_fan", &surface_fan, "surface"_a, "All beams of all tiles.");
    m.def(
        "open_project_library",
        [](const std::string& project_file, const Project& project,
           const std::string& wanted) -> LibraryPointer {
            auto opened = open_project_library(project_file, project, wanted);
            if (!opened) return nullptr;
            return std::make_shared<LibraryObject>(std::move(*opened), "library");
        },
        "project_file"_a, "project"_a, "wanted"_a = "",
        "The library for simulating a project: the wanted library, else the project's own, else None.");
}

}  // namespace

void bind_projects(py::module_& m) {
    bind_painting_choices(m);
    bind_recipes(m);
    bind_project(m);
    bind_making(m);
    bind_retiling(m);
    bind_surface(m);
}

}  // namespace fretwork::python
