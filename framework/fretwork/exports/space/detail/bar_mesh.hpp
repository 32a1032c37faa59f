// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/space/bar_scene.hpp>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace fretwork::exports::detail {

/// Triangles to be seen.
struct Mesh {
    struct Vertex {
        Eigen::Vector3f place;   ///< m
        Eigen::Vector3f normal;  ///< of length one
        Eigen::Vector3f colour;  ///< linear, 0 to 1
    };
    std::vector<Vertex> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The colours of bars, two for each bar: one at each end.
using EndColours = std::vector<Eigen::Vector3f>;

/// The bars, bent as their ends turn and moved by `scale` times their displacements, with round joints.
Mesh bar_mesh(const BarScene& scene, double scale, const EndColours& colours);

/// The number of straight pieces of each bar: one for every five degrees of its bend, at most twelve. 0: both
/// ends are at one place.
std::vector<int> bar_pieces(const BarScene& scene, double scale);

/// The first bar_mesh() with given numbers of pieces, so that states of one scene have equally many vertices
/// and the same triangles.
Mesh bar_mesh(const BarScene& scene, double scale, const EndColours& colours, std::span<const int> pieces);

/// Add a ball.
void add_ball(Mesh& mesh, const Eigen::Vector3d& center, double radius, const Eigen::Vector3f& colour);

}  // namespace fretwork::exports::detail
