// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/design/swaps/swap_table.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace fretwork::design::detail {

/// A swap table with the interactions between pairs of groups. It predicts the change of the residuals by
/// several swaps as the sum of the changes by single swaps and the interactions of all pairs. On the
/// linearized surface, this prediction is exact if at most two groups are swapped.
struct PairTable {
    SwapTable swaps;
    /// Interactions of the groups g < h, at pair_place(g, h): the change of the residuals by both swaps,
    /// minus the changes by each swap alone. A matrix has k rows (SwapTable::residual). In its column
    /// c + swaps.columns() * d, group g takes column c of the table, and group h takes column d.
    std::vector<Eigen::MatrixXd> crosses;
};

/// The index of the pair of groups g < h in PairTable::crosses.
constexpr std::size_t pair_place(std::size_t g, std::size_t h) {
    return h * (h - 1) / 2 + g;
}

/// The number of choices, columns^groups. If it exceeds `limit`, the result is `limit` + 1.
std::size_t choice_count(std::size_t groups, std::size_t columns, std::size_t limit);

/// Score all choices, and return the `count` choices with the best scores, the best first. A score is the
/// predicted objective if the steps of the continuous unknowns may have any size. The returned steps are
/// clipped as in best_steps(); Choice::objective is predicted for the clipped steps, so it may be out of
/// order. The cost is about 4 k operations for each of the choice_count() choices. Throws Stopped.
std::vector<Choice> best_of_all(const PairTable& table, std::size_t count, const base::Control& control);

}  // namespace fretwork::design::detail
