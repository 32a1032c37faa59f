// SPDX-License-Identifier: GPL-3.0-or-later
// The stiffness of the paper's reduced hexagon (Section 5.1), one plane at a time.
//
// Six links join interface node i (angle 270 + 60 i degrees, distance: the apothem) to ring node i (angle
// 270 + 60 i degrees + theta, distance R); six ring beams join neighbouring ring nodes. A flat frame's linear
// problem splits into one in the plane (ux uy rz: EA and EI3 count) and one out of it (uz rx ry: GJ and EI2
// count). Written in axes that turn with the nodes (radial, tangential, normal) all sectors are alike, so
// that four 3 x 3 blocks are enough.
#pragma once

#include <Eigen/Core>

#include <array>

namespace fretwork::reduction::detail {

inline constexpr int kSectors = 6;

/// Which three components of a node: (u_radial, u_tangential, r_z) or (u_z, r_radial, r_tangential).
enum class Plane { InPlane, OutOfPlane };

/// One plane's part of the six parameters.
struct PlaneParameters {
    double axial = 0.0;    ///< EA (N) in the plane, GJ (N m^2) out of it: what acts along the beam's axis
    double bending = 0.0;  ///< EI3 in the plane, EI2 out of it; N m^2
    double theta = 0.0;    ///< rad
    double R = 0.0;        ///< m
};
inline constexpr int kPlaneParameters = 4;

/// The blocks of the block-circulant stiffness matrix.
struct HexagonBlocks {
    Eigen::Matrix3d interface_own;   ///< interface node i with itself
    Eigen::Matrix3d interface_ring;  ///< interface node i with ring node i
    Eigen::Matrix3d ring_own;        ///< ring node i with itself
    Eigen::Matrix3d ring_next;       ///< ring node i with ring node i + 1
};

HexagonBlocks hexagon_blocks(Plane plane, const PlaneParameters& parameters, double apothem);

/// Their derivatives with respect to axial, bending, theta and R.
std::array<HexagonBlocks, kPlaneParameters> hexagon_block_derivatives(Plane plane,
                                                                      const PlaneParameters& parameters,
                                                                      double apothem);

/// Turn (x, y) components into the axes of a node at `angle`: local = turn * global.
Eigen::Matrix3d turn_to(Plane plane, double angle);

}  // namespace fretwork::reduction::detail
