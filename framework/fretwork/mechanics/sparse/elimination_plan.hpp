// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/sparse/supernodes.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace fretwork::mechanics::sparse {

/// Where supernodes leave something for their parents.
struct StoragePlan {
    std::vector<std::size_t> start;  ///< of each supernode's share
    std::size_t size = 0;            ///< of all
};

/// The tasks of an elimination: the supernodes of each task, and the storage for the rest of each supernode.
///
/// A task is a subtree of the elimination tree or, next to the roots, a single supernode. A task can start
/// when its children in the tree of tasks have ended. The division into tasks does not change any number,
/// because a supernode always adds its children in the same order.
struct EliminationPlan {
    std::vector<int> task_start;     ///< start of each task in `supernode`, and the end: tasks + 1
                                     ///< entries
    std::vector<int> supernode;      ///< supernodes of all tasks, ascending within each
    std::vector<int> parent;         ///< the later task that waits for this one; -1: none
    std::vector<int> level_start;    ///< levels + 1; the first level are the roots, the next their children
    std::vector<int> task_by_level;  ///< the tasks of each level
    StoragePlan rests;               ///< rows x rows, of a factorization
    StoragePlan updates;             ///< rows, of a substitution

    [[nodiscard]] std::span<const int> supernodes_of(std::size_t task) const {
        return std::span(supernode).subspan(task_start[task], task_start[task + 1] - task_start[task]);
    }
};

/// Plan the elimination of a tree. The plan is a single task for one thread, and for a tree too small to
/// profit from threads.
EliminationPlan plan_elimination(const SupernodeTree& tree, int threads);

}  // namespace fretwork::mechanics::sparse
