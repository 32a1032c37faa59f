// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/sparse/dense_ldlt.hpp>
#include <fretwork/mechanics/sparse/system_layout.hpp>

#include <cstddef>
#include <vector>

namespace fretwork::mechanics::sparse {

/// A supernode: neighbouring columns of a factor with the same rows below them.
struct Supernode {
    int first = 0;  ///< first equation
    int width = 0;
    int rows = 0;                 ///< number of rows below the supernode's own columns
    int parent = -1;              ///< supernode of the first row below the columns; -1: none
    std::size_t row_start = 0;    ///< start of the rows in SupernodeTree::row
    std::size_t panel_start = 0;  ///< start of the columns in the factor
    [[nodiscard]] int height() const { return width + rows; }
};

/// The order and storage of the elimination of a layout's matrices. The tree is computed once for each
/// layout.
struct SupernodeTree {
    std::vector<Supernode> supernodes;  ///< each comes before its parent
    /// Equations of the rows below each supernode's columns, ascending for each supernode.
    std::vector<int> row;
    /// Start of each supernode's children in `child`: supernode i has the children at [child_start[i],
    /// child_start[i + 1]).
    std::vector<int> child_start;
    std::vector<int> child;  ///< children of all supernodes, ascending for each supernode
    std::vector<int> place;  ///< position of each entry of `row` in the front of the supernode's
                             ///< parent
    /// Start of each supernode's runs in `run`, and the end: supernodes + 1 entries.
    std::vector<std::size_t> run_start;
    std::vector<RowRun> run;  ///< the places of `place`, as runs of neighbouring rows
    std::size_t factor_size = 0;
};

/// Find the supernodes of an elimination in the layout's order. A small supernode is merged with its parent
/// if the merger adds few zeros, because larger dense blocks are faster. Throws Stopped.
SupernodeTree supernode_tree(const SystemLayout& layout, const base::Control& control = {});

}  // namespace fretwork::mechanics::sparse
