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

/// A vector at each node, under a name for programs that show it.
struct NodeField {
    std::string name;
    Eigen::MatrixX3d vectors;
};

/// A number for each line, under a name for programs that show it.
struct LineField {
    std::string name;
    std::vector<double> values;
};

/// Lines in space with what is known at their nodes and of themselves: what every writer of 3D files takes.
struct LineSet {
    std::vector<Eigen::Vector3d> nodes;     ///< rest positions, metres
    std::vector<std::array<int, 2>> lines;  ///< pairs of nodes
    std::vector<int> tiles;                 ///< for each line its tile; empty: unknown
    std::vector<int> patterns;              ///< for each line the index of its pattern; empty: unknown
    std::optional<mechanics::NodeValues> displacements{};  ///< one row for each node
    std::vector<NodeField> fields{};                       ///< more to show beside them
    std::vector<LineField> line_fields{};                  ///< of each line
    std::vector<std::string> pattern_names{};              ///< ids, by index
};

/// All beams of a surface, undeformed; tiles that are not painted have none.
LineSet surface_lines(const simulation::Surface& surface);

/// Throws InputError unless the first nodes of the result are the surface's interface nodes.
void require_same_surface(const simulation::Surface& surface, const simulation::SurfaceResult& result);

/// A result as lines: all beams, if the result has a row for each of the surface's nodes (the full model);
/// else, for each tile, the closed line through its interface nodes (any reduced model). Throws InputError if
/// the result is not one of the surface.
LineSet result_lines(const simulation::Surface& surface, const simulation::SurfaceResult& result);

/// The same for programs that show fields: all beams, also those of condensed tiles, with radius (of a round
/// bar of the section's area), section forces (at the end where each is larger), stress and, given a strength
/// (Pa), utilization; and modes. Tiles whose model gives no motions of its beams have the lines of
/// result_lines, without forces. Throws as result_lines.
LineSet beam_lines(const simulation::Surface& surface, const simulation::SurfaceResult* result,
                   std::optional<double> strength = {},
                   std::span<const reduction::TileModel> models = reduction::tile_models());

/// The beams of any frame, straight and undeformed.
LineSet frame_lines(const mechanics::Frame& frame);

/// A frame's result with every division of its beams, and its modes as fields `vibration 1, 12.3 Hz` and
/// `buckling 1, 4.56 times the load`. The frame's nodes come first, in their order.
LineSet solution_lines(const mechanics::Assembly& assembly, const mechanics::Result& result);

/// The positions of the nodes with `scale` times their displacements.
std::vector<Eigen::Vector3d> displaced_nodes(const LineSet& lines, double scale = 1.0);

/// The beams of a calibrated tile model of a pattern, in the setting's regular polygon.
LineSet model_lines(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                    const reduction::Calibration& calibration, const reduction::Setting& setting,
                    std::span<const reduction::TileModel> models = reduction::tile_models());

}  // namespace fretwork::exports
