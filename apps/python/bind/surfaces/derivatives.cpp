// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of functions of a surface's displacements, by the adjoint method.
#include "core/bind.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/simulation/derivatives/candidate_tiles.hpp>
#include <fretwork/simulation/derivatives/sensitivity.hpp>

namespace fretwork::python {
namespace {

using namespace simulation;

/// One number of each tile.
std::vector<double> of_tiles(const Sensitivity& sensitivity, double TileSensitivity::*number) {
    std::vector<double> numbers;
    for (const TileSensitivity& tile : sensitivity.tiles) numbers.push_back(tile.*number);
    return numbers;
}

py::array_t<double> array_of(const std::vector<double>& numbers) {
    return py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

void bind_sensitivity(py::module_& m) {
    Record<Sensitivity>(m, "Sensitivity",
                        "The derivatives of a function J of a surface's displacements at an equilibrium, "
                        "with respect to the quantities on which the equilibrium depends.")
        .constant("loads", &Sensitivity::loads,
                  "n x 6 floats: with respect to forces (N) and true moments (N m) on each node")
        .constant("held_values", &Sensitivity::held_values,
                  "n x 6 floats: with respect to the values of held components, prescribed or zero; zero for "
                  "free components")
        .constant("stiffness", &Sensitivity::stiffness,
                  "with respect to a factor on the stiffness of all tiles, at 1")
        .type()
        .def_property_readonly(
            "tile_stiffness",
            [](const Sensitivity& self) { return array_of(of_tiles(self, &TileSensitivity::stiffness)); },
            "a float for each tile: with respect to a factor on its stiffness, at 1; NaN for tiles made of "
            "beams")
        .def_property_readonly(
            "tile_mass",
            [](const Sensitivity& self) { return array_of(of_tiles(self, &TileSensitivity::mass)); },
            "a float for each tile: with respect to its mass, 1/kg; its weight is a load");
}

}  // namespace

void bind_derivatives(py::module_& m) {
    bind_sensitivity(m);
    m.def("with_energy", &with_energy, "by"_a, "weight"_a, "energy"_a,
          "The sensitivity of J + weight U, where U is the elastic energy (result.solution.energy, J): adds "
          "the derivatives of U with respect to stiffnesses while nothing moves. The gradient that gave the "
          "sensitivity must include weight times Session.energy_gradient().");
    py::class_<CandidateTiles>(
        m, "CandidateTiles",
        "The condensed stiffness of every tile of a surface with each pattern of a palette.")
        .def(py::init([](const Surface& surface, const std::vector<std::string>& patterns, int threads) {
                 surface.setting.validate();
                 return CandidateTiles(surface, pattern::parse_named_patterns(surface.layout, patterns),
                                       CandidateTiles::Options{.threads = threads});
             }),
             "surface"_a, "patterns"_a, "threads"_a = 0, py::call_guard<py::gil_scoped_release>())
        .def_property_readonly("patterns", &CandidateTiles::patterns)
        .def(
            "stiffness",
            [](const CandidateTiles& self, std::ptrdiff_t tile, std::ptrdiff_t pattern) {
                const std::size_t known = checked_index(tile, self.tile_count(), "tile");
                const tiling::TileIndex index(static_cast<std::int32_t>(known));
                return self.stiffness(self.class_of(index),
                                      checked_index(pattern, self.patterns().size(), "pattern"));
            },
            "tile"_a, "pattern"_a,
            "6n x 6n floats, SI, in the axes in which tile models with sharing='congruent' build the tile.")
        .def_property_readonly("class_count", &CandidateTiles::class_count,
                               "number of classes; congruent tiles have the same class");
    m.def(
        "pattern_derivatives",
        [](const Sensitivity& sensitivity, const CandidateTiles& candidates) {
            if (sensitivity.tiles.size() != candidates.tile_count())
                throw base::InputError("the sensitivity is of " + std::to_string(sensitivity.tiles.size()) +
                                       " tiles, and the candidates of " +
                                       std::to_string(candidates.tile_count()));
            return pattern_derivatives(sensitivity, candidates);
        },
        "sensitivity"_a, "candidates"_a,
        "The first-order change of J if one tile had another pattern: tiles x patterns floats, for "
        "corotational and condensed tiles; NaN for others.");
    m.def(
        "derivative_along",
        [](const Sensitivity& sensitivity, const Surface& surface,
           const std::function<reduction::Setting(double)>& setting, double step) {
            if (sensitivity.tiles.size() != surface.tessellation.tiles.size())
                throw base::InputError("the sensitivity is of another surface");
            return derivative_along(sensitivity, surface, setting, step);
        },
        "sensitivity"_a, "surface"_a, "setting"_a, "step"_a,
        "The derivative of J along a curve of settings, setting(t), at t = 0; setting() is called at -2, -1, "
        "1 and 2 steps. Sections, joints, material and density affect stiffness and weight of the tiles.");
}

}  // namespace fretwork::python
