// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretwork::mechanics::sparse {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// Where each entry of the matrix comes in its column of a front.
std::vector<int> entry_places(const SystemLayout& layout, const SupernodeTree& tree) {
    std::vector<int> place(at(layout.equations()));
    std::vector<int> places(layout.row().size());
    for (const Supernode& supernode : tree.supernodes) {
        for (int i = 0; i < supernode.width; ++i) place[at(supernode.first + i)] = i;
        for (int i = 0; i < supernode.rows; ++i)
            place[at(tree.row[supernode.row_start + at(i)])] = supernode.width + i;
        const auto end = at(layout.column_start()[at(supernode.first + supernode.width)]);
        for (auto k = at(layout.column_start()[at(supernode.first)]); k < end; ++k)
            places[k] = place[at(layout.row()[k])];
    }
    return places;
}

}  // namespace

Ldlt::Ldlt(const SystemLayout& layout, int threads)
    : layout_(&layout),
      threads_(base::resolved_thread_count(threads)),
      tree_(supernode_tree(layout)),
      plan_(plan_elimination(tree_, threads_)),
      factor_(make_large_array(tree_.factor_size)),
      storage_(make_large_array(plan_.storage_size)),
      entry_place_(entry_places(layout, tree_)),
      diagonal_(at(layout.equations())),
      pivots_(tree_.supernodes.size()) {
    int most_rows = 0;
    for (const Supernode& supernode : tree_.supernodes) most_rows = std::max(most_rows, supernode.rows);
    scratch_.resize(at(most_rows));
}

Front Ldlt::front_of(std::size_t supernode) const {
    const Supernode& own = tree_.supernodes[supernode];
    return {own.width, own.rows, factor_.get() + own.panel_start,
            storage_.get() + plan_.rest_start[supernode]};
}

Ldlt::Outcome Ldlt::factorize(std::span<const double> values) {
    for (int i = 0; i < layout_->equations(); ++i) {
        diagonal_[at(i)] = values[at(layout_->column_start()[at(i)])];
    }
    require_finite(diagonal_);
    pivots_.assign(pivots_.size(), {});
    base::parallel_tree(plan_.parent, threads_, [&](std::size_t task) { eliminate_task(task, values); });
    Outcome outcome;
    for (std::size_t s = 0; s < pivots_.size() && outcome.zero_pivot < 0; ++s) {
        outcome.negative_pivots += pivots_[s].negative;
        outcome.has_weak_pivot = outcome.has_weak_pivot || pivots_[s].weak;
        if (pivots_[s].zero >= 0) outcome.zero_pivot = tree_.supernodes[s].first + pivots_[s].zero;
    }
    return outcome;
}

void Ldlt::eliminate_task(std::size_t task, std::span<const double> values) {
    // A thread's own, and kept by the caller's: small systems are factorized a thousand times a second.
    thread_local std::vector<double> scratch;
    for (const int supernode : plan_.supernodes_of(task)) {
        const auto s = at(supernode);
        const Supernode& own = tree_.supernodes[s];
        const Front front = front_of(s);
        const auto children =
            std::span(tree_.child)
                .subspan(at(tree_.child_start[s]), at(tree_.child_start[s + 1] - tree_.child_start[s]));
        // What follows a pivot that vanished is of no use; it is left out, so as to be the same always.
        const auto failed = [&](int child) { return pivots_[at(child)].zero >= 0; };
        if (std::any_of(children.begin(), children.end(), failed)) {
            pivots_[s].zero = 0;
            continue;
        }
        assemble(own, values, front);
        for (const int child : children) add_to_panel(at(child), front);
        const auto diagonal = std::span(diagonal_).subspan(at(own.first), at(own.width));
        pivots_[s] = eliminate(front, diagonal, kZeroPivot, scratch);
        if (pivots_[s].zero >= 0) continue;
        for (const int child : children) add_to_rest(at(child), front);
    }
}

/// Start the panel with the matrix's own entries.
void Ldlt::assemble(const Supernode& supernode, std::span<const double> values, const Front& front) const {
    const int height = supernode.height();
    for (int j = 0; j < front.width; ++j) std::fill_n(front.panel + at(j) * at(height + 1), height - j, 0.0);
    const int* start = layout_->column_start().data() + supernode.first;
    for (int column = 0; column < supernode.width; ++column) {
        double* target = front.panel + at(column) * at(height);
        for (auto k = at(start[column]); k < at(start[column + 1]); ++k) target[entry_place_[k]] = values[k];
    }
}

/// Add the columns of what a child has left that its parent eliminates: the first ones.
void Ldlt::add_to_panel(std::size_t child, const Front& front) const {
    const Supernode& own = tree_.supernodes[child];
    const int* place = tree_.place.data() + own.row_start;
    const double* source = storage_.get() + plan_.rest_start[child];
    for (int column = 0; column < own.rows && place[column] < front.width; ++column) {
        double* target = front.panel + at(place[column]) * at(front.width + front.rows);
        for (int i = column; i < own.rows; ++i) target[place[i]] += source[at(column) * at(own.rows) + at(i)];
    }
}

/// Add the others.
void Ldlt::add_to_rest(std::size_t child, const Front& front) const {
    const Supernode& own = tree_.supernodes[child];
    const int* place = tree_.place.data() + own.row_start;
    const double* source = storage_.get() + plan_.rest_start[child];
    const auto first = static_cast<int>(std::lower_bound(place, place + own.rows, front.width) - place);
    for (int column = first; column < own.rows; ++column) {
        double* target = front.rest + at(place[column] - front.width) * at(front.rows) - front.width;
        for (int i = column; i < own.rows; ++i) target[place[i]] += source[at(column) * at(own.rows) + at(i)];
    }
}

void Ldlt::solve_column(double* x) {
    for (std::size_t s = 0; s < tree_.supernodes.size(); ++s) {
        const Supernode& supernode = tree_.supernodes[s];
        // A load on a few nodes meets few supernodes on its way to the roots.
        const double* own = x + supernode.first;
        if (std::all_of(own, own + supernode.width, [](double value) { return value == 0.0; })) continue;
        std::fill_n(scratch_.data(), supernode.rows, 0.0);
        substitute_forward(front_of(s), x + supernode.first, scratch_.data());
        const int* row = tree_.row.data() + supernode.row_start;
        for (int i = 0; i < supernode.rows; ++i) x[row[i]] -= scratch_[at(i)];
    }
    for (std::size_t s = tree_.supernodes.size(); s-- > 0;) {
        const Supernode& supernode = tree_.supernodes[s];
        const int* row = tree_.row.data() + supernode.row_start;
        for (int i = 0; i < supernode.rows; ++i) scratch_[at(i)] = x[row[i]];
        substitute_back(front_of(s), x + supernode.first, scratch_.data());
    }
}

void Ldlt::solve(Eigen::VectorXd& right_side) {
    solve_column(right_side.data());
}

void Ldlt::solve(Eigen::MatrixXd& right_sides) {
    for (Eigen::Index i = 0; i < right_sides.cols(); ++i) solve_column(right_sides.col(i).data());
}

void add_product(const SystemLayout& layout, std::span<const double> values, const Eigen::VectorXd& x,
                 Eigen::VectorXd& y) {
    const auto& start = layout.column_start();
    for (int column = 0; column < layout.equations(); ++column) {
        auto k = at(start[at(column)]);
        const auto end = at(start[at(column) + 1]);
        double sum = values[k] * x[column];
        for (++k; k < end; ++k) {
            const int row = layout.row()[k];
            y[row] += values[k] * x[column];
            sum += values[k] * x[row];
        }
        y[column] += sum;
    }
}

}  // namespace fretwork::mechanics::sparse
