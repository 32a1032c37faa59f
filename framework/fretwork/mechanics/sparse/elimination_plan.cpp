// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/index.hpp>
#include <fretwork/mechanics/sparse/elimination_plan.hpp>

#include <algorithm>
#include <map>

namespace fretwork::mechanics::sparse {
namespace {

/// The least number of multiplications for each thread. With fewer, another thread would not pay off.
constexpr double kLittleWork = 5e6;

/// The largest subtree, as a share of one thread's multiplications, so that threads end at about the same
/// time.
constexpr double kPiece = 0.25;

using base::at;

/// An allocator of places in one piece of storage.
class Storage {
  public:
    std::size_t take(std::size_t size) {
        for (auto gap = gaps_.begin(); gap != gaps_.end(); ++gap) {
            if (gap->second < size) continue;
            const auto [start, length] = *gap;
            gaps_.erase(gap);
            if (length > size) gaps_.emplace(start + size, length - size);
            return start;
        }
        const std::size_t start = size_;
        size_ += size;
        return start;
    }

    void give_back(std::size_t start, std::size_t size) {
        if (size == 0) return;
        auto place = gaps_.emplace(start, size).first;
        const auto next = std::next(place);
        if (next != gaps_.end() && place->first + place->second == next->first) {
            place->second += next->second;
            gaps_.erase(next);
        }
        if (place == gaps_.begin()) return;
        const auto before = std::prev(place);
        if (before->first + before->second != place->first) return;
        before->second += place->second;
        gaps_.erase(place);
    }

    [[nodiscard]] std::size_t size() const { return size_; }

  private:
    std::map<std::size_t, std::size_t> gaps_;
    std::size_t size_ = 0;
};

/// The number of multiplications of each supernode with its subtree.
std::vector<double> subtree_work(const SupernodeTree& tree) {
    std::vector<double> work(tree.supernodes.size(), 0.0);
    for (std::size_t s = 0; s < work.size(); ++s) {
        const Supernode& own = tree.supernodes[s];
        work[s] += 0.5 * own.width * static_cast<double>(own.height()) * own.height();
        if (own.parent >= 0) work[at(own.parent)] += work[s];
    }
    return work;
}

/// A cut of the tree below every supernode whose subtree exceeds a piece.
class Cut {
  public:
    Cut(const SupernodeTree& tree, int threads) : tree_(tree), task_(tree.supernodes.size(), 0) {
        const std::vector<double> work = subtree_work(tree);
        double total = 0.0;
        for (std::size_t s = 0; s < work.size(); ++s) total += tree.supernodes[s].parent < 0 ? work[s] : 0.0;
        const double useful_threads = std::min<double>(threads, total / kLittleWork);
        if (useful_threads > 1.0) {
            cut(work, kPiece * total / useful_threads);
        } else {
            parent_.assign(1, -1);
        }
    }

    [[nodiscard]] const std::vector<int>& parents() const { return parent_; }
    [[nodiscard]] int task_of(std::size_t supernode) const { return task_[supernode]; }

  private:
    void cut(const std::vector<double>& work, double piece) {
        for (std::size_t s = work.size(); s-- > 0;) {
            const int parent = tree_.supernodes[s].parent;
            if (parent >= 0 && work[at(parent)] <= piece) {
                task_[s] = task_[at(parent)];
                continue;
            }
            task_[s] = static_cast<int>(parent_.size());
            parent_.push_back(parent < 0 ? -1 : task_[at(parent)]);
        }
        // Tasks are numbered from the roots, but children must come first.
        const int last = static_cast<int>(parent_.size()) - 1;
        for (int& task : task_) task = last - task;
        std::vector<int> turned(parent_.size());
        for (std::size_t t = 0; t < parent_.size(); ++t)
            turned[at(last) - t] = parent_[t] < 0 ? -1 : last - parent_[t];
        parent_ = std::move(turned);
    }

    const SupernodeTree& tree_;
    std::vector<int> task_;
    std::vector<int> parent_;
};

void list_supernodes(const Cut& cut, std::size_t supernodes, EliminationPlan& plan) {
    plan.task_start.assign(plan.parent.size() + 1, 0);
    for (std::size_t s = 0; s < supernodes; ++s) ++plan.task_start[at(cut.task_of(s)) + 1];
    for (std::size_t t = 0; t < plan.parent.size(); ++t) plan.task_start[t + 1] += plan.task_start[t];
    std::vector<int> next(plan.task_start.begin(), plan.task_start.end() - 1);
    plan.supernode.resize(supernodes);
    for (std::size_t s = 0; s < supernodes; ++s)
        plan.supernode[at(next[at(cut.task_of(s))]++)] = static_cast<int>(s);
}

/// A function that returns the number of values that a supernode passes to its parent.
using Handed = std::size_t (*)(const Supernode&);

/// Plan the storage of each supernode's values until its parent has taken them. Each task has its own
/// storage, so tasks do not affect each other.
StoragePlan plan_storage(const SupernodeTree& tree, const Cut& cut, const EliminationPlan& plan,
                         Handed handed) {
    constexpr std::size_t kCacheLine = 8;
    StoragePlan result;
    result.start.resize(tree.supernodes.size());
    for (std::size_t task = 0; task < plan.parent.size(); ++task) {
        Storage storage;
        for (const int s : plan.supernodes_of(task)) {
            result.start[at(s)] = result.size + storage.take(handed(tree.supernodes[at(s)]));
            for (int k = tree.child_start[at(s)]; k < tree.child_start[at(s) + 1]; ++k) {
                const auto child = at(tree.child[at(k)]);
                if (cut.task_of(child) == static_cast<int>(task))
                    storage.give_back(result.start[child] - result.size, handed(tree.supernodes[child]));
            }
        }
        result.size += (storage.size() + kCacheLine - 1) / kCacheLine * kCacheLine;
    }
    return result;
}

void list_levels(EliminationPlan& plan) {
    std::vector<int> level(plan.parent.size(), 0);
    int levels = 1;
    for (std::size_t t = level.size(); t-- > 0;) {  // reversed, because parents come last
        if (plan.parent[t] >= 0) level[t] = level[at(plan.parent[t])] + 1;
        levels = std::max(levels, level[t] + 1);
    }
    plan.level_start.assign(at(levels) + 1, 0);
    for (const int own : level) ++plan.level_start[at(own) + 1];
    for (std::size_t l = 0; l < at(levels); ++l) plan.level_start[l + 1] += plan.level_start[l];
    std::vector<int> next(plan.level_start.begin(), plan.level_start.end() - 1);
    plan.task_by_level.resize(level.size());
    for (std::size_t t = 0; t < level.size(); ++t)
        plan.task_by_level[at(next[at(level[t])]++)] = static_cast<int>(t);
}

}  // namespace

EliminationPlan plan_elimination(const SupernodeTree& tree, int threads) {
    const Cut cut(tree, threads);
    EliminationPlan plan;
    plan.parent = cut.parents();
    list_supernodes(cut, tree.supernodes.size(), plan);
    list_levels(plan);
    plan.rests =
        plan_storage(tree, cut, plan, [](const Supernode& own) { return at(own.rows) * at(own.rows); });
    plan.updates = plan_storage(tree, cut, plan, [](const Supernode& own) { return at(own.rows); });
    return plan;
}

}  // namespace fretwork::mechanics::sparse
