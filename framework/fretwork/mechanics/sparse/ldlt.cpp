// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/index.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretwork::mechanics::sparse {
namespace {

using base::at;

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

std::shared_ptr<const Ldlt::Analysis> Ldlt::analyse(const SystemLayout& layout, int threads,
                                                    const base::Control& control) {
    auto analysis = std::make_shared<Analysis>();
    analysis->layout = &layout;
    analysis->threads = base::resolved_thread_count(threads);
    analysis->tree = supernode_tree(layout, control);
    analysis->plan = plan_elimination(analysis->tree, analysis->threads);
    analysis->entry_place = entry_places(layout, analysis->tree);
    for (const Supernode& supernode : analysis->tree.supernodes)
        analysis->most_rows = std::max(analysis->most_rows, supernode.rows);
    return analysis;
}

Ldlt::Ldlt(std::shared_ptr<const Analysis> analysis)
    : analysis_(std::move(analysis)),
      factor_(make_large_array(analysis_->tree.factor_size)),
      storage_(make_large_array(analysis_->plan.storage_size)),
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
            storage_.get() + analysis_->plan.rest_start[supernode]};
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
    // A thread's own, and kept by the caller's: small systems are factorized a thousand times a second.
    thread_local std::vector<double> scratch;
    const Crew crew{analysis_->threads, control};
    for (const int supernode : analysis_->plan.supernodes_of(task)) {
        control.check();
        const auto s = at(supernode);
        const Supernode& own = analysis_->tree.supernodes[s];
        const Front front = front_of(s);
        const auto children =
            std::span(analysis_->tree.child)
                .subspan(at(analysis_->tree.child_start[s]),
                         at(analysis_->tree.child_start[s + 1] - analysis_->tree.child_start[s]));
        // The columns after a pivot that vanished are of no use; they are left out, so that results are
        // always the same.
        const auto failed = [&](int child) { return pivots_[at(child)].zero >= 0; };
        if (std::any_of(children.begin(), children.end(), failed)) {
            pivots_[s].zero = 0;
            continue;
        }
        assemble(own, values, front);
        for (const int child : children) add_to_panel(at(child), front);
        const auto diagonal = std::span(diagonal_).subspan(at(own.first), at(own.width));
        pivots_[s] = eliminate(front, {diagonal, kZeroPivot}, scratch, crew);
        if (pivots_[s].zero >= 0) continue;
        for (const int child : children) add_to_rest(at(child), front);
    }
}

/// Start the panel with the matrix's own entries.
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

/// Add the columns of what a child has left that its parent eliminates: the first ones.
void Ldlt::add_to_panel(std::size_t child, const Front& front) const {
    const Supernode& own = analysis_->tree.supernodes[child];
    const int* place = analysis_->tree.place.data() + own.row_start;
    const double* source = storage_.get() + analysis_->plan.rest_start[child];
    for (int column = 0; column < own.rows && place[column] < front.width; ++column) {
        double* target = front.panel + at(place[column]) * at(front.width + front.rows);
        for (int i = column; i < own.rows; ++i) target[place[i]] += source[at(column) * at(own.rows) + at(i)];
    }
}

/// Add the others.
void Ldlt::add_to_rest(std::size_t child, const Front& front) const {
    const Supernode& own = analysis_->tree.supernodes[child];
    const int* place = analysis_->tree.place.data() + own.row_start;
    const double* source = storage_.get() + analysis_->plan.rest_start[child];
    const auto first = static_cast<int>(std::lower_bound(place, place + own.rows, front.width) - place);
    for (int column = first; column < own.rows; ++column) {
        double* target = front.rest + at(place[column] - front.width) * at(front.rows) - front.width;
        for (int i = column; i < own.rows; ++i) target[place[i]] += source[at(column) * at(own.rows) + at(i)];
    }
}

void Ldlt::substitute_forward_in(std::size_t supernode, Columns columns, Workspace& work) const {
    const SupernodeTree& tree = analysis_->tree;
    const Supernode& own = tree.supernodes[supernode];
    const int* row = tree.row.data() + own.row_start;
    const Front front = front_of(supernode);
    for (Eigen::Index c = 0; c < columns.count; ++c) {
        work.control.check();
        double* x = columns.values + c * analysis_->layout->equations();
        double* first = x + own.first;
        // A load on a few nodes meets few supernodes on its way to the roots.
        if (std::all_of(first, first + own.width, [](double value) { return value == 0.0; })) continue;
        std::fill_n(work.scratch.data(), own.rows, 0.0);
        substitute_forward(front, first, work.scratch.data());
        for (int i = 0; i < own.rows; ++i) x[row[i]] -= work.scratch[at(i)];
    }
}

void Ldlt::substitute_back_in(std::size_t supernode, Columns columns, Workspace& work) const {
    const SupernodeTree& tree = analysis_->tree;
    const Supernode& own = tree.supernodes[supernode];
    const int* row = tree.row.data() + own.row_start;
    const Front front = front_of(supernode);
    for (Eigen::Index c = 0; c < columns.count; ++c) {
        work.control.check();
        double* x = columns.values + c * analysis_->layout->equations();
        for (int i = 0; i < own.rows; ++i) work.scratch[at(i)] = x[row[i]];
        substitute_back(front, x + own.first, work.scratch.data());
    }
}

void Ldlt::solve_columns(Columns columns, const base::Control& control) const {
    Workspace work{control, std::vector<double>(at(analysis_->most_rows))};
    const std::size_t supernodes = analysis_->tree.supernodes.size();
    for (std::size_t s = 0; s < supernodes; ++s) substitute_forward_in(s, columns, work);
    for (std::size_t s = supernodes; s-- > 0;) substitute_back_in(s, columns, work);
}

void Ldlt::solve(Eigen::VectorXd& right_side, const base::Control& control) const {
    solve_columns({right_side.data(), 1}, control);
}

void Ldlt::solve(Eigen::MatrixXd& right_sides, const base::Control& control) const {
    solve_columns({right_sides.data(), right_sides.cols()}, control);
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
    Workspace work{control, std::vector<double>(at(analysis_->most_rows))};
    Eigen::MatrixXd form = Eigen::MatrixXd::Zero(columns.cols(), columns.cols());
    for (const std::size_t s : path_from(equations)) {
        substitute_forward_in(s, {columns.data(), columns.cols()}, work);
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
