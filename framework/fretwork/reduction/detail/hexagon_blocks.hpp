// SPDX-License-Identifier: GPL-3.0-or-later
// The stiffness of a hexagonal ring with links (the paper's Section 5.1), one plane at a time.
//
// Six links join interface node i (angle 270 + 60 i degrees, distance: the apothem) to ring node i (angle 270
// + 60 i degrees + theta, distance R); six ring beams join neighbouring ring nodes. A flat frame's linear
// problem splits into one in the plane (ux uy rz: EA and EI3 count) and one out of it (uz rx ry: GJ and EI2
// count). In axes that turn with the nodes (radial, tangential, normal), all sectors are alike, so four 3 x 3
// blocks define the stiffness.
#pragma once

#include <Eigen/Core>

#include <array>

namespace fretwork::reduction::detail {

inline constexpr int kSectors = 6;

/// The plane of a problem, with three components of each node: (u_radial, u_tangential, r_z) or (u_z,
/// r_radial, r_tangential).
enum class Plane { InPlane, OutOfPlane };

/// The number of parameters of one plane. The parameters are, in this order: the stiffness of the links along
/// their axes (EA in the plane, N; GJ out of it, N m^2) and in bending (EI3 in the plane, EI2 out of it, N
/// m^2); the same two of the ring; theta (rad); R (m).
inline constexpr int kPlaneParameters = 6;
using PlaneParameters = std::array<double, kPlaneParameters>;

/// The blocks of the block-circulant stiffness matrix.
struct HexagonBlocks {
    Eigen::Matrix3d interface_own;   ///< interface node i with itself
    Eigen::Matrix3d interface_ring;  ///< interface node i with ring node i
    Eigen::Matrix3d ring_own;        ///< ring node i with itself
    Eigen::Matrix3d ring_next;       ///< ring node i with ring node i + 1
};

HexagonBlocks hexagon_blocks(Plane plane, const PlaneParameters& parameters, double apothem);

/// The derivatives of the blocks with respect to each parameter.
std::array<HexagonBlocks, kPlaneParameters> hexagon_block_derivatives(Plane plane,
                                                                      const PlaneParameters& parameters,
                                                                      double apothem);

HexagonBlocks no_blocks();
void add_blocks(HexagonBlocks& sum, double factor, const HexagonBlocks& blocks);
/// The sum of the products of corresponding entries.
double sum_of_products(const HexagonBlocks& one, const HexagonBlocks& other);

/// The matrix that turns (x, y) components into the axes of a node at `angle`: local = turn * global.
Eigen::Matrix3d turn_to(Plane plane, double angle);

}  // namespace fretwork::reduction::detail
