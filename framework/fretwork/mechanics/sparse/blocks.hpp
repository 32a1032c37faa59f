// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>

namespace fretwork::mechanics::sparse {

/// Rows and columns of the block that a matrix has for each pair of coupled nodes: the most unknowns that a
/// node has.
inline constexpr int kBlockSize = 6;

/// Which components of a node are unknowns.
using Components = std::array<bool, kBlockSize>;

/// One row of components for each node.
using NodeTable = Eigen::Matrix<double, Eigen::Dynamic, kBlockSize, Eigen::RowMajor>;

}  // namespace fretwork::mechanics::sparse
