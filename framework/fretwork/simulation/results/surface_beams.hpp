// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/mechanics/results/section_forces.hpp>
#include <fretwork/simulation/session.hpp>
#include <fretwork/simulation/surface.hpp>

#include <array>
#include <span>
#include <vector>

namespace fretwork::simulation {

/// The beams of a surface as they lie in the plane, whatever models its tiles have: what is drawn.
struct SurfaceBeams {
    std::size_t interface_nodes = 0;     ///< the first nodes, with their own ids
    std::vector<Eigen::Vector3d> nodes;  ///< rest positions, m; behind the interface nodes tile by tile
    std::vector<std::array<mechanics::NodeIndex, 2>> ends;
    std::vector<tiling::TileIndex> tiles;  ///< of each beam
    std::vector<double> joint_reaches;     ///< of each beam: reduction::joint_reaches
    /// For each tile the first of its inner nodes and of its beams, and behind the last tile their numbers.
    struct Start {
        std::size_t inner_node = 0;
        std::size_t beam = 0;
    };
    std::vector<Start> starts;
};

/// The nodes are those of the full model, in its order. Tiles that are not painted have no beams.
SurfaceBeams surface_beams(const Surface& surface);

/// Computes section forces from the motions of the beams' ends, for each beam of a setting's material and
/// section.
std::vector<mechanics::BeamSection> beam_sections(const SurfaceBeams& beams,
                                                  const reduction::Setting& setting);

/// How the beams of a surface are displaced and strained. NaN where a tile model does not give it.
struct BeamState {
    mechanics::NodeValues nodes;  ///< a row for each node of the beams
    /// The columns of kBeamFields, two rows for each beam: its ends.
    Eigen::Matrix<double, Eigen::Dynamic, 8> forces;
};
/// Section forces (N and N m), the largest normal stress and the largest von Mises stress over the section
/// (Pa).
inline constexpr std::array<const char*, 8> kBeamFields = {"N",  "V2", "V3",     "T",
                                                           "M2", "M3", "stress", "von_mises"};
inline constexpr Eigen::Index kStressField = 6;
inline constexpr Eigen::Index kVonMisesField = 7;

/// The beams in a solution that the session gave since its last edit.
///
/// @param sections  of the beams; empty: no forces are wanted
BeamState beam_state(const Session& session, const mechanics::Solution& solution, const SurfaceBeams& beams,
                     std::span<const mechanics::BeamSection> sections);
/// The same in a result that was read from a file, with the tile models that its subject names
/// (rows of `models`); without a
/// subject, with all beams if it has a row for each of their nodes. The tiles are built for it. Throws
/// InputError if the result is not one of the surface with these models.
BeamState beam_state(const Surface& surface, const SurfaceResult& result, const SurfaceBeams& beams,
                     std::span<const mechanics::BeamSection> sections,
                     std::span<const reduction::TileModel> models = reduction::tile_models());

}  // namespace fretwork::simulation
