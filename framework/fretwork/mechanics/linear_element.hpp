// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/element.hpp>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace fretwork::mechanics {

/// The matrices that define a linear element of n nodes; each is 6n x 6n, in the order of the nodes.
struct LinearMatrices {
    Eigen::MatrixXd stiffness;  ///< stiffness, symmetric
    Eigen::MatrixXd mass{};     ///< mass at rest; empty: not known, and natural frequencies are refused
};

/// A linear element of any number of nodes, such as a condensed tile. Throws InputError if the size of a
/// matrix does not fit the number of nodes.
std::unique_ptr<const Element> linear_element(std::vector<NodeIndex> nodes, LinearMatrices matrices);

}  // namespace fretwork::mechanics
