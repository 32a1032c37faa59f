// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/sparse/supernodes.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace fretwork::mechanics::sparse {

/// The places in a storage for the numbers that supernodes pass to their parents.
struct StoragePlan {
    std::vector<std::size_t> start;  ///< start of each supernode's share of the storage
    std::size_t size = 0;            ///< size of the whole storage
};

/// The tasks of an elimination: the supernodes of each task, and the storage for the rest of each supernode.
///
/// A task has the supernodes of a subtree of the elimination tree or, near the roots, a single supernode. A
/// task can start when its children in the tree of tasks have ended. The division into tasks does not change
/// any number, because a supernode always adds its children in the same order.
struct EliminationPlan {
    /// Start of each task in `supernode`, and the end of the last task: tasks + 1 entries.
    std::vector<int> task_start;
    std::vector<int> supernode;  ///< supernodes of all tasks, ascending within each task
    std::vector<int> parent;     ///< for each task, the later task that waits for it; -1: none
    /// Start of each level in `task_by_level`, and the end of the last level: levels + 1 entries; the first
    /// level has the roots, the next level their children.
    std::vector<int> level_start;
    std::vector<int> task_by_level;  ///< tasks, sorted by level
    StoragePlan rests;               ///< storage of a factorization, rows x rows for each supernode
    StoragePlan updates;             ///< storage of a substitution, one number for each row of a supernode

    [[nodiscard]] std::span<const int> supernodes_of(std::size_t task) const {
        return std::span(supernode).subspan(task_start[task], task_start[task + 1] - task_start[task]);
    }
};

/// Plan the elimination of a tree. The plan has a single task for one thread, and for a tree too small to
/// profit from threads.
EliminationPlan plan_elimination(const SupernodeTree& tree, int threads);

}  // namespace fretwork::mechanics::sparse
