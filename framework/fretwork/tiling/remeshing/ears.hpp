// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/remeshing/triangulation.hpp>

namespace fretwork::tiling::detail {

/// Give the corners of the outline that triangles of three rim points cut off to the tiles behind them: the
/// edge between is flipped where the two triangles make a convex quadrilateral. Throws base::Stopped.
void flip_ears(Triangulation& triangulation, const Work& work);

/// The ends of an edge inside that joins two points of the rim.
struct Chord {
    PointIndex from;
    PointIndex to;
};
/// The remaining edges of this kind. Where one lies, the tiles on both sides of it share no side, or a part
/// of the outline has no tile.
std::vector<Chord> chords_of(const Triangulation& triangulation);

}  // namespace fretwork::tiling::detail
