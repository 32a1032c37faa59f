// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>

namespace fretwork::mechanics::sparse {

/// The size of the matrix block of a pair of coupled nodes, which is the largest number of unknowns of a
/// node.
inline constexpr int kBlockSize = 6;

/// For each component of a node, true if it is an unknown.
using Components = std::array<bool, kBlockSize>;

/// A table with one row of components for each node.
using NodeTable = Eigen::Matrix<double, Eigen::Dynamic, kBlockSize, Eigen::RowMajor>;

}  // namespace fretwork::mechanics::sparse
