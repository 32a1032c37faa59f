// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <vector>

namespace fretwork::outlines {

/// The content of a mesh file.
struct MeshFile {
    std::vector<std::array<double, 3>> points;
    /// Indices into `points`: at least three, in range, each once.
    std::vector<std::vector<int>> faces;
};

/// Read a mesh (OBJ, PLY, OFF) by the ending of its file; it may lie anywhere in space. Throws InputError
/// with file and place, also if it has no face.
MeshFile read_space_mesh(const std::filesystem::path& path);

/// The same, and check that it lies in a plane
/// z = constant. Throws InputError or GeometryError with file and place.
MeshFile read_flat_mesh(const std::filesystem::path& path);

}  // namespace fretwork::outlines
