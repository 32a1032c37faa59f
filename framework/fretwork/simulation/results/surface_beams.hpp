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

/// The beams of a surface at rest, for drawings and stresses. They do not depend on the tile models.
struct SurfaceBeams {
    std::size_t interface_nodes = 0;  ///< number of interface nodes; these come first, with their own numbers
    /// Positions at rest, m; inner nodes follow the interface nodes, tile by tile.
    std::vector<Eigen::Vector3d> nodes;
    std::vector<std::array<mechanics::NodeIndex, 2>> ends;  ///< the two ends of each beam
    std::vector<tiling::TileIndex> tiles;                   ///< tile of each beam
    /// reduction::joint_reaches() of each beam, in widths of a bar.
    std::vector<double> joint_reaches;
    /// The beginning of a tile's inner nodes and beams.
    struct Start {
        std::size_t inner_node = 0;  ///< index of the tile's first inner node
        std::size_t beam = 0;        ///< index of the tile's first beam
    };
    std::vector<Start> starts;  ///< start of each tile; one further entry has the numbers of nodes and beams
};

/// Collect the beams of a surface. The nodes are the nodes of the full model, in the same order. Unpainted
/// tiles have no beams.
SurfaceBeams surface_beams(const Surface& surface);

/// The distance below which two nodes at rest are the same node, m.
inline constexpr double kSamePlace = 1e-9;
/// True if the nodes of a result lie at these places, in this order. To compare the numbers of nodes does not
/// suffice: a model with inner nodes of its own may have as many as the patterns.
bool has_nodes_at(const SurfaceResult& result, std::span<const Eigen::Vector3d> places);

/// For each beam, an object that computes section forces from the motions of the beam's ends.
std::vector<mechanics::BeamSection> beam_sections(const SurfaceBeams& beams,
                                                  const reduction::Setting& setting);

/// The displacements and forces of the beams of a surface. Values that a tile model does not give are NaN.
struct BeamState {
    mechanics::NodeValues nodes;  ///< displacements (m, rad), one row for each node of the beams
    /// The section forces and stresses: two rows for each beam, one for each end, and the columns of
    /// kBeamFields.
    Eigen::Matrix<double, Eigen::Dynamic, 8> forces;
};
/// The columns of BeamState::forces: section forces (N and N m), and the largest normal stress and the
/// largest von Mises stress over the section (Pa).
inline constexpr std::array<const char*, 8> kBeamFields = {"N",  "V2", "V3",     "T",
                                                           "M2", "M3", "stress", "von_mises"};
/// The column of the largest normal stress.
inline constexpr Eigen::Index kStressField = 6;
/// The column of the largest von Mises stress.
inline constexpr Eigen::Index kVonMisesField = 7;

/// The state of the beams in a solution since the session's last edit. Throws InputError as
/// Session::require_since_edit(); Stopped.
///
/// @param sections  the result of beam_sections(); empty: forces are not computed
BeamState beam_state(const Session& session, const mechanics::Solution& solution, const SurfaceBeams& beams,
                     std::span<const mechanics::BeamSection> sections, const base::Control& control = {});
/// The state of the beams in a result from a file. The tiles are built with the main model and the full tiles
/// of the result's subject, and with the surface's own tile models; all must be rows of `models`. A result
/// without a subject counts as one of the full model if it has a row for each node of the beams; otherwise,
/// all values but the displacements of interface nodes are NaN. Throws InputError if a tile model is unknown,
/// if a tile is not painted or lacks a calibration, or if the numbers of nodes show that the result does not
/// belong to the surface with these tile models; Stopped.
BeamState beam_state(const Surface& surface, const SurfaceResult& result, const SurfaceBeams& beams,
                     std::span<const mechanics::BeamSection> sections,
                     std::span<const reduction::TileModel> models = reduction::tile_models(),
                     const base::Control& control = {});
/// The states of the beams at the end of each load step or stage of a result from a file, one for each of
/// Result::load_steps. The tiles are built once. Throws as beam_state().
std::vector<BeamState> step_beam_states(const Surface& surface, const SurfaceResult& result,
                                        const SurfaceBeams& beams,
                                        std::span<const mechanics::BeamSection> sections,
                                        std::span<const reduction::TileModel> models,
                                        const base::Control& control = {});

}  // namespace fretwork::simulation
