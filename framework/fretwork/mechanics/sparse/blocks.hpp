// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>

namespace fretwork::mechanics::sparse {

/// The largest number of unknowns at a node. A pair of coupled nodes has a matrix block of at most this size.
inline constexpr int kBlockSize = 6;

/// The components of a node; true for each component that is an unknown.
using Components = std::array<bool, kBlockSize>;

/// A table with one row for each node and one column for each component.
using NodeTable = Eigen::Matrix<double, Eigen::Dynamic, kBlockSize, Eigen::RowMajor>;

}  // namespace fretwork::mechanics::sparse
