// SPDX-License-Identifier: GPL-3.0-or-later
// Forward substitution goes through the supernodes as the factorization does: each supernode takes the
// updates of its children, in order, and passes its own update to its parent. Back substitution goes the
// other way, from the roots to the leaves. Both use the tasks of the factorization, and no sum depends on the
// number of threads.
#include <fretwork/base/index.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>

#include <algorithm>

namespace fretwork::mechanics::sparse {
namespace {

using base::at;

/// The largest number of values in the updates of columns that are substituted at a time.
constexpr std::size_t kMostUpdates = 4'000'000;

/// Add the update of a child to the supernode's own unknowns, and to the supernode's own update.
void take_update(std::span<const RowRun> runs, const double* update, int width, double* own, double* below) {
    for (const RowRun& run : runs) {
        const double* from = update + run.from;
        if (run.to < width) {
            for (int i = 0; i < run.length; ++i) own[run.to + i] -= from[i];
        } else {
            for (int i = 0; i < run.length; ++i) below[run.to - width + i] += from[i];
        }
    }
}

}  // namespace

Ldlt::Substitution Ldlt::begin(Columns columns, const base::Control& control) const {
    return {columns,
            std::vector<double>(static_cast<std::size_t>(columns.count) * analysis_->plan.updates.size),
            control};
}

void Ldlt::substitute_forward_in(std::size_t supernode, std::span<const int> children,
                                 Substitution& substitution) const {
    const StoragePlan& plan = analysis_->plan.updates;
    const Front front = front_of(supernode);
    const int first = analysis_->tree.supernodes[supernode].first;
    for (Eigen::Index c = 0; c < substitution.columns.count; ++c) {
        substitution.control.check();
        double* own = substitution.columns.values + c * analysis_->layout->equations() + first;
        double* below = substitution.update(plan.start[supernode], c, plan.size);
        std::fill_n(below, front.rows, 0.0);
        for (const int child : children) {
            const double* update = substitution.update(plan.start[at(child)], c, plan.size);
            take_update(remainder_of(at(child)).runs, update, front.width, own, below);
        }
        // A load on a few nodes reaches only few supernodes on its way to the roots.
        if (std::all_of(own, own + front.width, [](double value) { return value == 0.0; })) continue;
        substitute_forward(front, own, below);
    }
}

void Ldlt::substitute_back_in(std::size_t supernode, Substitution& substitution) const {
    const StoragePlan& plan = analysis_->plan.updates;
    const Front front = front_of(supernode);
    const Supernode& own = analysis_->tree.supernodes[supernode];
    const int* row = analysis_->tree.row.data() + own.row_start;
    for (Eigen::Index c = 0; c < substitution.columns.count; ++c) {
        substitution.control.check();
        double* x = substitution.columns.values + c * analysis_->layout->equations();
        double* below = substitution.update(plan.start[supernode], c, plan.size);
        for (int i = 0; i < own.rows; ++i) below[i] = x[row[i]];
        substitute_back(front, x + own.first, below);
    }
}

void Ldlt::solve_columns(Columns columns, const base::Control& control) const {
    const EliminationPlan& plan = analysis_->plan;
    const auto at_a_time = static_cast<Eigen::Index>(
        std::max<std::size_t>(1, kMostUpdates / std::max<std::size_t>(1, plan.updates.size)));
    for (Eigen::Index first = 0; first < columns.count; first += at_a_time) {
        Substitution substitution = begin({columns.values + first * analysis_->layout->equations(),
                                           std::min(at_a_time, columns.count - first)},
                                          control);
        base::parallel_tree(plan.parent, analysis_->threads, [&](std::size_t task) {
            for (const int s : plan.supernodes_of(task))
                substitute_forward_in(at(s), children_of(at(s)), substitution);
        });
        for (std::size_t level = 0; level + 1 < plan.level_start.size(); ++level) {
            const auto start = at(plan.level_start[level]);
            base::parallel_for(
                at(plan.level_start[level + 1]) - start, analysis_->threads, [&](std::size_t i) {
                    const auto supernodes = plan.supernodes_of(at(plan.task_by_level[start + i]));
                    for (std::size_t k = supernodes.size(); k-- > 0;)
                        substitute_back_in(at(supernodes[k]), substitution);
                });
        }
    }
}

void Ldlt::solve(Eigen::VectorXd& right_side, const base::Control& control) const {
    solve_columns({right_side.data(), 1}, control);
}

void Ldlt::solve(Eigen::MatrixXd& right_sides, const base::Control& control) const {
    solve_columns({right_sides.data(), right_sides.cols()}, control);
}

}  // namespace fretwork::mechanics::sparse
