// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/tessellate.hpp>

#include <filesystem>

namespace fretwork::tiling {

/// Read a flat OBJ, PLY or OFF mesh and take its faces as tiles, as they are; so any tessellation by another
/// program can be painted. Paper, Section 6. Tiles, vertices and interface nodes get new numbers. Faces may
/// all run clockwise (a mesh that is seen from below).
///
/// Throws InputError or GeometryError that names the face: if it is not convex, or does not share whole sides
/// with its neighbours (a vertex on the middle of a side, an overlap, a second face on the same side of a
/// side), or if the faces are not connected by sides, or touch elsewhere in a single vertex.
TessellationResult read_mesh_tessellation(const std::filesystem::path& path,
                                          const pattern::NodeLayout& layout);

}  // namespace fretwork::tiling
