// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/surface.hpp>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::exports {

/// A named vector at each node.
struct NodeField {
    std::string name;          ///< name in files
    Eigen::MatrixX3d vectors;  ///< vectors, one row for each node
};

/// A named number for each line.
struct LineField {
    std::string name;            ///< name in files
    std::vector<double> values;  ///< values, one for each line
};

/// Lines in space with fields at their nodes and on the lines, the input of the writers in line_files.hpp.
struct LineSet {
    std::vector<Eigen::Vector3d> nodes;     ///< rest positions, metres
    std::vector<std::array<int, 2>> lines;  ///< the two nodes of each line
    std::vector<int> tiles;                 ///< tile of each line; empty: not known
    std::vector<int> patterns;              ///< index of the pattern of each line; empty: not known
    std::optional<mechanics::NodeValues> displacements{};  ///< displacement and rotation of each node
    std::vector<NodeField> fields{};                       ///< further fields at the nodes
    std::vector<LineField> line_fields{};                  ///< fields on the lines
    std::vector<std::string> pattern_names{};              ///< ids of the patterns, by index
    /// Name of the joints of the setting; empty: not known.
    std::string joints{};
};

/// All beams of a surface at rest. Unpainted tiles have no beams.
LineSet surface_lines(const simulation::Surface& surface);

/// Check that the first nodes of a result are the surface's interface nodes. Throws InputError.
void require_same_surface(const simulation::Surface& surface, const simulation::SurfaceResult& result);

/// A result as lines. A result of the full model has a row for each node of the beams, and gives all beams.
/// Any other result gives a closed line through the interface nodes of each tile. Throws InputError if the
/// result does not belong to the surface.
LineSet result_lines(const simulation::Surface& surface, const simulation::SurfaceResult& result);

/// The beams of a surface with fields of a result, also in condensed tiles. The fields are the radius (of a
/// round bar with the section's area), the section forces (each at the end where it is larger), the stresses,
/// the modes and, if `strength` (Pa) is given, the utilization. If any tile's model does not give the motions
/// of beams, the lines are those of result_lines() with the radius alone. Null `result`: the beams at rest.
/// Throws as result_lines().
LineSet beam_lines(const simulation::Surface& surface, const simulation::SurfaceResult* result,
                   std::optional<double> strength = {},
                   std::span<const reduction::TileModel> models = reduction::tile_models());

/// The beams of a frame, at rest.
LineSet frame_lines(const mechanics::Frame& frame);

/// A frame's result as lines, one for each division of its beams. The modes of the result are fields named
/// `vibration 1, 12.3 Hz` and `buckling 1, 4.56 times the load`. The frame's nodes come first, in their
/// order.
LineSet solution_lines(const mechanics::Assembly& assembly, const mechanics::Result& result);

/// The positions of the nodes, displaced by `scale` times their displacements.
std::vector<Eigen::Vector3d> displaced_nodes(const LineSet& lines, double scale = 1.0);

/// The beams of a calibrated tile model of a pattern, in the setting's regular polygon. Throws InputError if
/// `models` has no row for the calibration, or a row with other parameters.
LineSet model_lines(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                    const reduction::Calibration& calibration, const reduction::Setting& setting,
                    std::span<const reduction::TileModel> models = reduction::tile_models());

}  // namespace fretwork::exports
