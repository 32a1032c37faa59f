// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame.hpp>
#include <fretwork/simulation/selection.hpp>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace fretwork::simulation {

/// Supports and loads of a tessellation, all of them on interface nodes, which every tile model has.
struct LoadCase {
    struct Support {
        Selection where;
        mechanics::DofSet fixed;
    };
    /// Whether each picked node gets the load, or all of them together.
    enum class Amount { Each, Total };
    struct Load {
        Selection where;
        Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
        Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m, fixed direction in space
        Amount amount = Amount::Each;
    };
    struct PrescribedDisplacement {
        Selection where;
        mechanics::Dof dof = mechanics::Dof::ux;
        double value = 0.0;  ///< m or rad
    };
    std::string name;
    std::string description;
    std::vector<Support> supports;
    std::vector<Load> loads;
    std::vector<PrescribedDisplacement> prescribed;
    /// m/s^2. The weight of a tile's beams is shared evenly by its interface nodes, in every model: paper,
    /// Section 7.3.
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
};

}  // namespace fretwork::simulation
