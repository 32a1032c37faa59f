// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/sparse/dense_ldlt.hpp>
#include <fretwork/mechanics/sparse/system_layout.hpp>

#include <cstddef>
#include <vector>

namespace fretwork::mechanics::sparse {

/// Neighbouring columns of a factor with the same rows below them.
struct Supernode {
    int first = 0;  ///< its first equation
    int width = 0;
    int rows = 0;                 ///< number of rows below its own columns
    int parent = -1;              ///< the supernode of the first row below; -1: none
    std::size_t row_start = 0;    ///< start of its rows in SupernodeTree::row
    std::size_t panel_start = 0;  ///< start of its columns in the factor
    [[nodiscard]] int height() const { return width + rows; }
};

/// The order and storage of the elimination of a layout's matrices. It is computed once for each layout.
struct SupernodeTree {
    std::vector<Supernode> supernodes;   ///< each comes before its parent
    std::vector<int> row;                ///< equations of the rows below, ascending for each supernode
    std::vector<int> child_start;        ///< children of supernode i: [child_start[i], child_start[i + 1]) of
                                         ///< `child`
    std::vector<int> child;              ///< ascending for each supernode
    std::vector<int> place;              ///< position of each entry of `row` in the front of the supernode's
                                         ///< parent
    std::vector<std::size_t> run_start;  ///< supernodes + 1
    std::vector<RowRun> run;             ///< the same places, run by run
    std::size_t factor_size = 0;
};

/// Find the supernodes of an elimination in the layout's order. A small supernode is merged with its parent
/// if that adds few zeros, because larger dense blocks are faster. Throws Stopped.
SupernodeTree supernode_tree(const SystemLayout& layout, const base::Control& control = {});

}  // namespace fretwork::mechanics::sparse
