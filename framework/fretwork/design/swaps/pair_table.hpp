// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/design/swaps/swap_table.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace fretwork::design::detail {

/// A swap table with the interactions of any two groups. The change of the residuals by several swaps is the
/// sum of the changes by each swap and of the crosses of each two swaps; a table with the crosses is exact
/// for one or two swaps of the linearized surface.
struct PairTable {
    SwapTable swaps;
    /// For two groups g < h, at pair_place(g, h): the change of the residuals by both swaps, less the changes
    /// by each. k rows; the column c + swaps.columns() * d is for column c in group g and column d in group
    /// h.
    std::vector<Eigen::MatrixXd> crosses;
};

/// Place of the pair of groups g < h in PairTable::crosses.
constexpr std::size_t pair_place(std::size_t g, std::size_t h) {
    return h * (h - 1) / 2 + g;
}

/// The number of choices of a column for each group, or `limit` + 1 if it is larger than `limit`.
std::size_t choice_count(std::size_t groups, std::size_t columns, std::size_t limit);

/// The `count` choices that are predicted to be the best among all choices, the best first, with the best
/// steps of the continuous unknowns. Scores choice_count() choices, each by 2 k operations. Throws Stopped.
std::vector<Choice> best_of_all(const PairTable& table, std::size_t count, const base::Control& control);

}  // namespace fretwork::design::detail
