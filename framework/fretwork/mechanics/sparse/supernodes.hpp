// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/sparse/system_layout.hpp>

#include <cstddef>
#include <vector>

namespace fretwork::mechanics::sparse {

/// Neighbouring columns of a factor that share their rows below, and what they hand on.
struct Supernode {
    int first = 0;  ///< equation
    int width = 0;
    int rows = 0;                 ///< below its own columns
    int parent = -1;              ///< the supernode of the first row below; -1: none
    std::size_t row_start = 0;    ///< of its rows in SupernodeTree::row
    std::size_t panel_start = 0;  ///< of its columns in the factor
    [[nodiscard]] int height() const { return width + rows; }
};

/// How a system's matrix is eliminated: found once for a layout.
struct SupernodeTree {
    std::vector<Supernode> supernodes;  ///< each comes before its parent
    std::vector<int> row;               ///< equations of the rows below, ascending for each supernode
    std::vector<int> child_start;       ///< supernodes + 1
    std::vector<int> child;             ///< ascending for each supernode
    std::vector<int> place;             ///< of each of `row` in the front of the supernode's parent
    std::size_t factor_size = 0;
};

/// The elimination in the layout's order. Small supernodes are merged with their parents where few zeros come
/// in: larger dense blocks are faster.
/// Throws Stopped.
SupernodeTree supernode_tree(const SystemLayout& layout, const base::Control& control = {});

}  // namespace fretwork::mechanics::sparse
