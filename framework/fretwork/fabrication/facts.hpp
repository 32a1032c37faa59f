// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/fabrication/narrow_places.hpp>
#include <fretwork/fabrication/shape.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/results/surface_result.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::fabrication {

/// The limits of a machine and a material.
struct FactsOptions {
    double clearance = 5e-4;           ///< m: warn about narrower gaps and openings
    double layer_height = 2e-4;        ///< m, height of a layer of a print
    double sharp_angle = 0.35;         ///< rad: warn about bars meeting at a smaller angle
    std::optional<double> strength{};  ///< Pa: warn about higher stresses; none: the material's
    std::span<const reduction::TileModel> models = reduction::tile_models();  ///< tile models of the result
    base::Control control{};  ///< how the caller follows and stops the work
    /// Throws InputError that names an invalid option.
    void validate() const;
};

/// A warning to the maker, and its place.
struct Warning {
    std::string message;     ///< one line, with tile, node and place
    geometry::Point2 place;  ///< m
};

/// The facts that a maker needs before making a surface. SI.
///
/// The sag, and the stresses of a load case with gravity, take the weight of the true outline: the factor
/// `mass` / `beam_mass` scales gravity on the whole surface. So the weight of a border and of eyes for bolts
/// is spread over the tiles; their stiffness is ignored.
struct Facts {
    std::size_t tiles = 0, bars = 0, pieces = 0, openings = 0;
    reduction::Joints joints = reduction::Joints::Centreline;  ///< joints in the model of sag and stress
    geometry::Box box{};                                       ///< of the outline, m
    double height = 0.0;                                       ///< m, of the section
    double area = 0.0;                                         ///< m2, of the true outline
    double volume = 0.0;                                       ///< m3
    double mass = 0.0;                                         ///< kg; 0 if the material has no density
    double beam_mass = 0.0;                  ///< kg, mass of the model's beams, which overlap in joints
    double cut_length = 0.0;                 ///< m
    std::size_t pierces = 0;                 ///< number of contours; a cutter pierces the material once for
                                             ///< each
    std::size_t layers = 0;                  ///< number of layers of a print
    double wall_length = 0.0;                ///< m, length of the contours of all layers
    double sharpest_angle = 0.0;             ///< rad, between bars of a node
    std::optional<NarrowPlace> narrowest{};  ///< the narrowest of all gaps and openings up to twice a bar's
                                             ///< width
    double smallest_radius = 0.0;            ///< m, smallest radius of inner corners; 0: sharp
    /// The deflection under the surface's own weight on the supports of a load case, computed with
    /// corotational tiles at large displacements. If their path does not reach the whole weight, there is a
    /// warning and no sag.
    struct Sag {
        std::string load_case;    ///< whose supports hold
        double weight = 0.0;      ///< N, load on the supports: `mass` times 9.80665 m/s2
        double deflection = 0.0;  ///< m, the largest
        geometry::Point2 place;   ///< m, at rest
    };
    std::optional<Sag> sag{};  ///< under its own weight
    /// The largest normal stress of a beam.
    struct Stress {
        std::string source;          ///< the load case, or the result
        double value = 0.0;          ///< Pa
        TileIndex tile;              ///< where it is
        TessellationNodeIndex node;  ///< where it is
    };
    std::optional<Stress> stress{};    ///< under the load case
    std::optional<double> strength{};  ///< Pa, the given strength or the material's
    std::vector<Warning> warnings;     ///< what may fail when it is made
};

/// The load case, or the result, for stresses.
struct FactsLoads {
    const simulation::LoadCase* load_case = nullptr;  ///< may be null
    /// A solution of the surface under the weight of the beams; it is not scaled to `mass`. If null, the load
    /// case is solved with corotational tiles.
    const simulation::SurfaceResult* result = nullptr;
};

/// Collect the facts of a surface. Throws as make_shape(), and as simulation::simulate().
Facts facts(const simulation::Surface& surface, const ShapeOptions& shape, const FactsLoads& loads,
            const FactsOptions& options = {});

}  // namespace fretwork::fabrication
