// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/index.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fretwork::mechanics::sparse {
namespace {

using base::at;

/// The row of each entry of the matrix in its column of a front.
std::vector<int> entry_places(const SystemLayout& layout, const SupernodeTree& tree,
                              const base::Control& control) {
    std::vector<int> place(at(layout.equations()));
    std::vector<int> places(layout.row().size());
    for (const Supernode& supernode : tree.supernodes) {
        control.check();
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

std::shared_ptr<const Ldlt::Analysis> Ldlt::analyse(const SystemLayout& layout, int threads,
                                                    const base::Control& control) {
    auto analysis = std::make_shared<Analysis>();
    analysis->layout = &layout;
    analysis->threads = base::resolved_thread_count(threads);
    analysis->tree = supernode_tree(layout, control);
    analysis->plan = plan_elimination(analysis->tree, analysis->threads);
    analysis->entry_place = entry_places(layout, analysis->tree, control);
    return analysis;
}

Ldlt::Ldlt(std::shared_ptr<const Analysis> analysis)
    : analysis_(std::move(analysis)),
      factor_(make_large_array(analysis_->tree.factor_size)),
      storage_(make_large_array(analysis_->plan.rests.size)),
      diagonal_(at(analysis_->layout->equations())),
      pivots_(analysis_->tree.supernodes.size()) {}

Ldlt::Ldlt(const SystemLayout& layout, int threads, const base::Control& control)
    : Ldlt(analyse(layout, threads, control)) {}

Ldlt Ldlt::another() const {
    return Ldlt(analysis_);
}

Front Ldlt::front_of(std::size_t supernode) const {
    const Supernode& own = analysis_->tree.supernodes[supernode];
    return {own.width, own.rows, factor_.get() + own.panel_start,
            storage_.get() + analysis_->plan.rests.start[supernode]};
}

Ldlt::Outcome Ldlt::factorize(std::span<const double> values, const base::Control& control) {
    for (int i = 0; i < analysis_->layout->equations(); ++i) {
        diagonal_[at(i)] = values[at(analysis_->layout->column_start()[at(i)])];
    }
    require_finite(diagonal_);
    pivots_.assign(pivots_.size(), {});
    base::parallel_tree(analysis_->plan.parent, analysis_->threads,
                        [&](std::size_t task) { eliminate_task(task, values, control); });
    Outcome outcome;
    for (std::size_t s = 0; s < pivots_.size() && outcome.zero_pivot < 0; ++s) {
        outcome.negative_pivots += pivots_[s].negative;
        outcome.has_weak_pivot = outcome.has_weak_pivot || pivots_[s].weak;
        if (pivots_[s].zero >= 0) outcome.zero_pivot = analysis_->tree.supernodes[s].first + pivots_[s].zero;
    }
    return outcome;
}

void Ldlt::eliminate_task(std::size_t task, std::span<const double> values, const base::Control& control) {
    // Each thread has its own memory and keeps it, because a thousand small systems are factorized in a
    // second.
    thread_local std::vector<double> scratch;
    const Concurrency concurrency{analysis_->threads, control};
    for (const int supernode : analysis_->plan.supernodes_of(task)) {
        control.check();
        const auto s = at(supernode);
        const Supernode& own = analysis_->tree.supernodes[s];
        const Front front = front_of(s);
        const std::span<const int> children = children_of(s);
        // Columns after a pivot that vanished are of no use. They are left out, so that results do not depend
        // on threads.
        const auto failed = [&](int child) { return pivots_[at(child)].zero >= 0; };
        if (std::any_of(children.begin(), children.end(), failed)) {
            pivots_[s].zero = 0;
            continue;
        }
        assemble(own, values, front);
        for (const int child : children) add_to_panel(remainder_of(at(child)), front);
        const auto diagonal = std::span(diagonal_).subspan(at(own.first), at(own.width));
        pivots_[s] = eliminate(front, {diagonal, kZeroPivot}, scratch, concurrency);
        if (pivots_[s].zero >= 0) continue;
        for (const int child : children) add_to_rest(remainder_of(at(child)), front);
    }
}

/// Fill the panel with the entries of the matrix.
void Ldlt::assemble(const Supernode& supernode, std::span<const double> values, const Front& front) const {
    const int height = supernode.height();
    for (int j = 0; j < front.width; ++j) std::fill_n(front.panel + at(j) * at(height + 1), height - j, 0.0);
    const int* start = analysis_->layout->column_start().data() + supernode.first;
    for (int column = 0; column < supernode.width; ++column) {
        double* target = front.panel + at(column) * at(height);
        for (auto k = at(start[column]); k < at(start[column + 1]); ++k)
            target[analysis_->entry_place[k]] = values[k];
    }
}

Remainder Ldlt::remainder_of(std::size_t supernode) const {
    const SupernodeTree& tree = analysis_->tree;
    const std::size_t first = tree.run_start[supernode];
    return {storage_.get() + analysis_->plan.rests.start[supernode], tree.supernodes[supernode].rows,
            std::span(tree.run).subspan(first, tree.run_start[supernode + 1] - first)};
}

std::span<const int> Ldlt::children_of(std::size_t supernode) const {
    const SupernodeTree& tree = analysis_->tree;
    const auto first = at(tree.child_start[supernode]);
    return std::span(tree.child).subspan(first, at(tree.child_start[supernode + 1]) - first);
}

std::vector<std::size_t> Ldlt::path_from(std::span<const int> equations) const {
    const auto& supernodes = analysis_->tree.supernodes;
    std::vector<bool> on_path(supernodes.size(), false);
    const auto starts_after = [](int equation, const Supernode& supernode) {
        return equation < supernode.first;
    };
    for (const int equation : equations) {
        const auto after = std::upper_bound(supernodes.begin(), supernodes.end(), equation, starts_after);
        for (int s = static_cast<int>(after - supernodes.begin()) - 1; s >= 0 && !on_path[at(s)];
             s = supernodes[at(s)].parent)
            on_path[at(s)] = true;
    }
    std::vector<std::size_t> path;
    for (std::size_t s = 0; s < on_path.size(); ++s) {
        if (on_path[s]) path.push_back(s);
    }
    return path;
}

Eigen::MatrixXd Ldlt::inverse_form(Eigen::MatrixXd columns, std::span<const int> equations,
                                   const base::Control& control) const {
    Substitution substitution = begin({columns.data(), columns.cols()}, control);
    Eigen::MatrixXd form = Eigen::MatrixXd::Zero(columns.cols(), columns.cols());
    std::vector<bool> is_on_path(analysis_->tree.supernodes.size(), false);
    std::vector<int> children;
    for (const std::size_t s : path_from(equations)) {
        is_on_path[s] = true;
        children.clear();
        std::ranges::copy_if(children_of(s), std::back_inserter(children),
                             [&](int child) { return is_on_path[at(child)]; });
        substitute_forward_in(s, children, substitution);
        const Front front = front_of(s);
        Eigen::MatrixXd rows = columns.middleRows(analysis_->tree.supernodes[s].first, front.width);
        for (int i = 0; i < front.width; ++i)
            rows.row(i) /= std::sqrt(front.panel[at(i) * at(front.width + front.rows + 1)]);
        form.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
    }
    return form.selfadjointView<Eigen::Lower>();
}

double Ldlt::factorization_work() const {
    double work = 0.0;
    for (const Supernode& own : analysis_->tree.supernodes)
        work += 0.5 * own.width * static_cast<double>(own.height()) * own.height();
    return work;
}

double Ldlt::solution_work() const {
    return 2.0 * static_cast<double>(analysis_->tree.factor_size);
}

double Ldlt::inverse_form_work(std::span<const int> equations, Eigen::Index columns) const {
    const auto count = static_cast<double>(columns);
    double work = 0.0;
    for (const std::size_t s : path_from(equations)) {
        const Supernode& own = analysis_->tree.supernodes[s];
        work += own.width * count * (own.height() + 0.5 * count);
    }
    return work;
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
