// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/tables/line_set.hpp>

#include <string>

namespace fretwork::exports {

/// Lines in VTK's XML format for ParaView, in ASCII with all digits: rest positions, point data
/// `displacement`, `rotation` and LineSet::fields, and, if the tiles are known, cell data `tile`, `pattern`
/// and LineSet::line_fields. Field data are `pattern_names` and `joints`, if they are known. ParaView's
/// filter Warp By Vector shows the deformed state.
std::string vtu_text(const LineSet& lines);

/// Lines as Wavefront OBJ with line elements, at the displaced positions.
std::string obj_text(const LineSet& lines);

/// Lines as PLY (ASCII) with vertices and edges, at the displaced positions.
std::string ply_text(const LineSet& lines);

/// A table of the nodes: number, rest position, displacement and rotation vector, SI.
std::string csv_text(const LineSet& lines);

}  // namespace fretwork::exports
