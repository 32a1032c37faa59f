// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/design/swaps/swap_table.hpp>

#include <Eigen/Core>

#include <vector>

namespace fretwork::design::detail {

/// A mixture of columns for each group, instead of one column.
struct RelaxedChoice {
    std::vector<Eigen::VectorXd> weights;  ///< for each group the weights of its columns, which sum up to 1
    double objective = 0.0;                ///< predicted sum of squares
    double gap = 0.0;  ///< no mixture has a predicted sum of squares below `objective` - `gap`
};

/// Solve the relaxation of the integer least squares problem of a table: each group takes a weighted mean of
/// its columns' responses. This convex problem is solved by pairwise Frank-Wolfe steps, group by group
/// [LacosteJulien2015]. Energy, mass and the steps of the continuous unknowns have no limits. Throws Stopped.
RelaxedChoice relaxed_choice(const SwapTable& table, const std::vector<std::size_t>& start,
                             const base::Control& control);

}  // namespace fretwork::design::detail
