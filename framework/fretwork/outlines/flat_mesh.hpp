// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <vector>

namespace fretwork::outlines {

/// The content of a mesh file.
struct MeshFile {
    std::vector<std::array<double, 3>> points;  ///< x, y, z in m
    /// The indices into `points` of each face: at least three, in range and distinct.
    std::vector<std::vector<int>> faces;
};

/// Throw InputError unless a path has the extension of a mesh: .obj, .ply or .off.
void check_mesh_ending(const std::filesystem::path& path);

/// Read a mesh in space from an OBJ, PLY or OFF file; the file extension selects the format. Throws
/// InputError with file and place, also if the mesh has no face.
MeshFile read_space_mesh(const std::filesystem::path& path);

/// Read a mesh as read_space_mesh does, and check that z is constant up to a millionth of the mesh's size.
/// Throws InputError or GeometryError with file and place.
MeshFile read_flat_mesh(const std::filesystem::path& path);

}  // namespace fretwork::outlines
