// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/fabrication/narrow_places.hpp>
#include <fretwork/fabrication/shape.hpp>
#include <fretwork/fabrication/sheets.hpp>
#include <fretwork/simulation/load_cases/load_case.hpp>
#include <fretwork/simulation/results/surface_result.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::fabrication {

/// Options of facts(): the limits of a machine and a material.
struct FactsOptions {
    /// Gaps and openings narrower than this, m, give a warning.
    double clearance = 5e-4;
    double layer_height = 2e-4;  ///< height of a layer of a print, m
    /// Angles between bars smaller than this, rad, give a warning.
    double sharp_angle = 0.35;
    /// Stresses higher than this, Pa, give a warning; none: the strength in the setting.
    std::optional<double> strength{};
    /// Bed for which the surface is cut into parts: the warning on openings that the kerf closes then counts
    /// the openings of the parts. None: those of the outline in one piece.
    std::optional<Bed> bed{};
    /// Catalogue with the tile models of the surface and of the result.
    std::span<const reduction::TileModel> models = reduction::tile_models();
    base::Control control{};  ///< progress and stop
    /// Throws InputError that names an invalid option.
    void validate() const;
};

/// A warning to the maker.
struct Warning {
    std::string message;                      ///< text in one line, with tile, node and place
    std::optional<geometry::Point2> place{};  ///< m; none if the warning is about the whole surface
};

/// The facts about a surface that its maker needs, in SI units.
///
/// The sag, and the stress under a load case with gravity, are computed with the weight of the true outline:
/// gravity on the whole surface is multiplied by `mass` / `beam_mass`. This spreads the weight of a border
/// and of eyes for bolts over the tiles. The stiffness of border and eyes is ignored.
struct Facts {
    std::size_t tiles = 0;     ///< number of tiles
    std::size_t bars = 0;      ///< number of bars
    std::size_t pieces = 0;    ///< number of separate pieces of material
    std::size_t openings = 0;  ///< number of openings
    /// Treatment of joints in the model for sag and stress.
    reduction::Joints joints = reduction::Joints::Centreline;
    geometry::Box box{};  ///< box around the outline, m
    double height = 0.0;  ///< height of the section, m
    double area = 0.0;    ///< area of the true outline, m2
    double volume = 0.0;  ///< m3
    /// Mass of the true outline, kg; 0 if the material has no density.
    double mass = 0.0;
    double beam_mass = 0.0;   ///< mass of the model's beams, kg; beams overlap in joints
    double cut_length = 0.0;  ///< total length of all contours of the true outline, m
    /// Number of contours: a cutter pierces the material once for each.
    std::size_t pierces = 0;
    std::size_t layers = 0;       ///< number of layers of a print
    double wall_length = 0.0;     ///< total length of the contours of all layers, m
    double sharpest_angle = 0.0;  ///< smallest angle between two bars at a node, rad; none: 2 pi
    /// The narrowest gap or opening, if one is narrower than the clearance or twice a bar's width.
    std::optional<NarrowPlace> narrowest{};
    double smallest_radius = 0.0;  ///< smallest radius of an inner corner, m; 0: sharp, or no inner corner
    /// The deflection under the surface's own weight on the supports of a load case, computed with
    /// corotational tiles. There is no sag without supports or density. If the supports, without prescribed
    /// displacements, do not hold the surface, or if the equilibrium path does not reach the whole weight,
    /// there is a warning and no sag.
    struct Sag {
        std::string load_case;    ///< name of the load case with the supports
        double weight = 0.0;      ///< load on the supports, N: `mass` times 9.80665 m/s2
        double deflection = 0.0;  ///< largest deflection of an interface node, m
        geometry::Point2 place;   ///< place of the largest deflection, m, at rest
    };
    std::optional<Sag> sag{};  ///< sag under the surface's own weight
    /// The largest von Mises stress of a beam, at the end of any load step or load stage.
    struct Stress {
        /// "load case" and its name, or "the result". If there are load stages or load steps, then also the
        /// name of the load stage, or the number of the load step, with the stress.
        std::string source;
        double value = 0.0;          ///< stress, Pa
        TileIndex tile;              ///< tile of the beam
        TessellationNodeIndex node;  ///< node at the end of the beam with the stress
    };
    /// Largest stress under FactsLoads. If the equilibrium path does not reach the whole load, there is a
    /// warning and no stress.
    std::optional<Stress> stress{};
    std::optional<double> strength{};  ///< strength, Pa: the strength in FactsOptions or in the setting
    std::vector<Warning> warnings;     ///< warnings about possible failures in making the surface
};

/// The load case or the result for sag and stress.
struct FactsLoads {
    const simulation::LoadCase* load_case = nullptr;  ///< load case; may be null
    /// A result of the surface for the stress. Its weight is the weight of the beams, not scaled to `mass`.
    /// If null, the load case is solved with corotational tiles.
    const simulation::SurfaceResult* result = nullptr;
};

/// Collect the facts of a surface. Throws InputError if an option is invalid. Throws also as make_shape(),
/// simulation::simulate() and simulation::beam_state().
Facts facts(const simulation::Surface& surface, const ShapeOptions& shape, const FactsLoads& loads,
            const FactsOptions& options = {});

}  // namespace fretwork::fabrication
