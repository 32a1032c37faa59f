// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/detail/ldlt.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretwork::mechanics::detail {
namespace {

/// A pivot that has lost this many digits against its diagonal is zero: what is left of it is rounding.
constexpr double kZeroPivot = 64.0 * std::numeric_limits<double>::epsilon();

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

}  // namespace

Ldlt::Ldlt(const SystemLayout& layout)
    : layout_(&layout),
      tree_(supernode_tree(layout)),
      factor_(make_large_array(tree_.factor_size)),
      storage_(make_large_array(tree_.storage_size)),
      diagonal_(at(layout.equations())),
      place_(at(layout.equations())) {
    int most_rows = 0;
    for (const Supernode& supernode : tree_.supernodes) most_rows = std::max(most_rows, supernode.rows);
    scratch_.resize(at(most_rows));
    child_place_.resize(at(most_rows));
}

Front Ldlt::front_of(const Supernode& supernode) {
    return {supernode.width, supernode.rows, factor_.get() + supernode.panel_start,
            storage_.get() + supernode.rest_start};
}

Ldlt::Outcome Ldlt::factorize(std::span<const double> values) {
    for (int i = 0; i < layout_->equations(); ++i) {
        diagonal_[at(i)] = values[at(layout_->column_start()[at(i)])];
        if (!std::isfinite(diagonal_[at(i)]))
            throw base::NumericalError("the stiffness holds a number that is not finite");
    }
    Outcome outcome;
    for (std::size_t s = 0; s < tree_.supernodes.size(); ++s) {
        const Supernode& supernode = tree_.supernodes[s];
        const Front front = front_of(supernode);
        assemble(supernode, values, front);
        for (int k = tree_.child_start[s]; k < tree_.child_start[s + 1]; ++k)
            add_rest(tree_.supernodes[at(tree_.child[at(k)])], front);
        const auto diagonal = std::span(diagonal_).subspan(at(supernode.first), at(supernode.width));
        const Pivots pivots = eliminate(front, diagonal, kZeroPivot, scratch_);
        outcome.negative_pivots += pivots.negative;
        if (pivots.zero < 0) continue;
        outcome.zero_pivot = supernode.first + pivots.zero;
        break;
    }
    return outcome;
}

/// Start the front with the matrix's own entries.
void Ldlt::assemble(const Supernode& supernode, std::span<const double> values, const Front& front) {
    const int height = supernode.height();
    for (int j = 0; j < front.width; ++j) std::fill_n(front.panel + at(j) * at(height + 1), height - j, 0.0);
    for (int j = 0; j < front.rows; ++j)
        std::fill_n(front.rest + at(j) * at(front.rows + 1), front.rows - j, 0.0);
    for (int i = 0; i < supernode.width; ++i) place_[at(supernode.first + i)] = i;
    for (int i = 0; i < supernode.rows; ++i)
        place_[at(tree_.row[supernode.row_start + at(i)])] = supernode.width + i;
    const int* start = layout_->column_start().data() + supernode.first;
    for (int column = 0; column < supernode.width; ++column) {
        double* target = front.panel + at(column) * at(height);
        for (int k = start[column]; k < start[column + 1]; ++k)
            target[place_[at(layout_->row()[at(k)])]] = values[at(k)];
    }
}

/// Add what a child has left.
void Ldlt::add_rest(const Supernode& child, const Front& front) {
    for (int i = 0; i < child.rows; ++i) child_place_[at(i)] = place_[at(tree_.row[child.row_start + at(i)])];
    const int* place = child_place_.data();
    const int height = front.width + front.rows;
    for (int column = 0; column < child.rows; ++column) {
        const int j = place[column];
        double* target = j < front.width ? front.panel + at(j) * at(height)
                                         : front.rest + at(j - front.width) * at(front.rows) - front.width;
        const double* source = storage_.get() + child.rest_start + at(column) * at(child.rows);
        for (int i = column; i < child.rows; ++i) target[place[i]] += source[i];
    }
}

void Ldlt::solve_column(double* x) {
    for (const Supernode& supernode : tree_.supernodes) {
        std::fill_n(scratch_.data(), supernode.rows, 0.0);
        substitute_forward(front_of(supernode), x + supernode.first, scratch_.data());
        const int* row = tree_.row.data() + supernode.row_start;
        for (int i = 0; i < supernode.rows; ++i) x[row[i]] -= scratch_[at(i)];
    }
    for (std::size_t s = tree_.supernodes.size(); s-- > 0;) {
        const Supernode& supernode = tree_.supernodes[s];
        const int* row = tree_.row.data() + supernode.row_start;
        for (int i = 0; i < supernode.rows; ++i) scratch_[at(i)] = x[row[i]];
        substitute_back(front_of(supernode), x + supernode.first, scratch_.data());
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

}  // namespace fretwork::mechanics::detail
