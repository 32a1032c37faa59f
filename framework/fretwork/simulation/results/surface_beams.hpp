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

/// The beams of a surface at rest, whatever models its tiles have. Drawings show them.
struct SurfaceBeams {
    std::size_t interface_nodes = 0;  ///< number of them; they are the first nodes, with their own ids
    std::vector<Eigen::Vector3d>
        nodes;  ///< positions at rest, m; inner nodes follow the interface nodes, tile by tile
    std::vector<std::array<mechanics::NodeIndex, 2>> ends;
    std::vector<tiling::TileIndex> tiles;  ///< of each beam
    std::vector<double> joint_reaches;     ///< of each beam: reduction::joint_reaches
    /// For each tile its first inner node and its first beam; after the last tile, the numbers of both.
    struct Start {
        std::size_t inner_node = 0;
        std::size_t beam = 0;
    };
    std::vector<Start> starts;
};

/// The nodes are those of the full model, in its order. Tiles that are not painted have no beams.
SurfaceBeams surface_beams(const Surface& surface);

/// For each beam the section, with the setting's material, that turns motions of its ends into forces.
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

/// The state of the beams in a solution that the session gave since its last edit.
///
/// @param sections  one for each beam; empty: forces are not computed
BeamState beam_state(const Session& session, const mechanics::Solution& solution, const SurfaceBeams& beams,
                     std::span<const mechanics::BeamSection> sections);
/// The same in a result that was read from a file. Its tiles are built with the models that its subject
/// names, which are rows of `models`. A result without a subject is taken as one of the full model if it has
/// a row for each node of the beams. Throws InputError if the result is not one of the surface with these
/// models.
BeamState beam_state(const Surface& surface, const SurfaceResult& result, const SurfaceBeams& beams,
                     std::span<const mechanics::BeamSection> sections,
                     std::span<const reduction::TileModel> models = reduction::tile_models());

}  // namespace fretwork::simulation
