// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/sparse/supernodes.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace fretwork::mechanics::sparse {

/// The tasks of an elimination: the supernodes of each task, and the storage for the rest of each supernode.
///
/// A task is a subtree of the elimination tree or, next to the roots, a single supernode. A task can start
/// when its children in the tree of tasks have ended. The division into tasks does not change any number,
/// because a supernode always adds its children in the same order.
struct EliminationPlan {
    std::vector<int> task_start;          ///< start of each task in `supernode`, and the end: tasks + 1
                                          ///< entries
    std::vector<int> supernode;           ///< supernodes of all tasks, ascending within each
    std::vector<int> parent;              ///< the later task that waits for this one; -1: none
    std::vector<std::size_t> rest_start;  ///< start of each supernode's rest in the working storage
    std::size_t storage_size = 0;

    [[nodiscard]] std::span<const int> supernodes_of(std::size_t task) const {
        return std::span(supernode).subspan(task_start[task], task_start[task + 1] - task_start[task]);
    }
};

/// Plan the elimination of a tree. The plan is a single task for one thread, and for a tree too small to
/// profit from threads.
EliminationPlan plan_elimination(const SupernodeTree& tree, int threads);

}  // namespace fretwork::mechanics::sparse
