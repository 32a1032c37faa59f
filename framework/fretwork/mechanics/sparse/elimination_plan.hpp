// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/sparse/supernodes.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace fretwork::mechanics::sparse {

/// Which supernodes are eliminated together, and where each leaves its rest meanwhile.
///
/// A task is a subtree of the elimination tree or, next to the roots, a single supernode; it can start when
/// the tasks that hand something on to it have ended. How the tree is cut changes no number: a supernode
/// always meets its children in the same order.
struct EliminationPlan {
    std::vector<int> task_start;          ///< tasks + 1
    std::vector<int> supernode;           ///< of the tasks, ascending for each
    std::vector<int> parent;              ///< the task that waits for this one, later than it; -1: none
    std::vector<std::size_t> rest_start;  ///< of each supernode's rest in the working storage
    std::size_t storage_size = 0;

    [[nodiscard]] std::span<const int> supernodes_of(std::size_t task) const {
        return std::span(supernode).subspan(task_start[task], task_start[task + 1] - task_start[task]);
    }
};

/// One task for one thread, and for a tree whose elimination is not worth starting threads.
EliminationPlan plan_elimination(const SupernodeTree& tree, int threads);

}  // namespace fretwork::mechanics::sparse
