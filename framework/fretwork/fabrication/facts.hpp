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
    double layer_height = 2e-4;        ///< m, of a print
    double sharp_angle = 0.35;         ///< rad: warn about bars meeting at a smaller angle
    std::optional<double> strength{};  ///< Pa: warn about higher stresses; none: the material's
    std::span<const reduction::TileModel> models = reduction::tile_models();  ///< of the result
    base::Control control{};
    /// Throws InputError that names the option.
    void validate() const;
};

/// A warning to the maker, and its place.
struct Warning {
    std::string message;  ///< one line, with tile, node and place
    geometry::Point2 place;
};

/// The facts that a maker needs before making a surface. SI.
///
/// The weight of the true outline acts in the sag and in the stresses of a load case with gravity: one factor
/// for the whole surface, `mass` / `beam_mass`, scales the gravity of its tiles. The weight of a frame and of
/// eyes for bolts is thus spread over the tiles; their stiffness is ignored.
struct Facts {
    std::size_t tiles = 0, bars = 0, pieces = 0, openings = 0;
    reduction::Joints joints = reduction::Joints::Centreline;  ///< of the beams that give sag and stress
    geometry::Box box{};
    double height = 0.0;
    double area = 0.0;                       ///< m2, of the true outline
    double volume = 0.0;                     ///< m3
    double mass = 0.0;                       ///< kg; 0 where the material has no density
    double beam_mass = 0.0;                  ///< kg, of the model's beams: joints count more than once
    double cut_length = 0.0;                 ///< m
    std::size_t pierces = 0;                 ///< contours, each of which a cutter starts separately
    std::size_t layers = 0;                  ///< of a print
    double wall_length = 0.0;                ///< m, contours of all layers
    double sharpest_angle = 0.0;             ///< rad, between bars of a node
    std::optional<NarrowPlace> narrowest{};  ///< of all gaps and openings up to twice a bar's width
    double smallest_radius = 0.0;            ///< m, of inner corners; 0: sharp
    /// Under its own weight on the supports of a load case, by corotational tiles and large displacements;
    /// none, and a warning, where their path does not reach the whole weight.
    struct Sag {
        std::string load_case;
        double weight = 0.0;      ///< N, what the supports bear: `mass` times 9.80665 m/s2
        double deflection = 0.0;  ///< m, the largest
        geometry::Point2 place;
    };
    std::optional<Sag> sag{};
    /// The largest normal stress of a beam.
    struct Stress {
        std::string source;  ///< the load case, or the result
        double value = 0.0;  ///< Pa
        TileIndex tile;
        TessellationNodeIndex node;
    };
    std::optional<Stress> stress{};
    std::optional<double> strength{};  ///< Pa, as given or the material's
    std::vector<Warning> warnings;
};

/// A load case, or a result, to judge stresses by.
struct FactsLoads {
    const simulation::LoadCase* load_case = nullptr;
    /// A solution of the surface under the weight of the beams, taken as it is; if none, the load case is
    /// solved with corotational tiles.
    const simulation::SurfaceResult* result = nullptr;
};

/// Throws as make_shape(), and as simulation::simulate().
Facts facts(const simulation::Surface& surface, const ShapeOptions& shape, const FactsLoads& loads,
            const FactsOptions& options = {});

}  // namespace fretwork::fabrication
