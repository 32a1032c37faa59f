// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/swaps/swap_table.hpp>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace fretwork::design::detail {

struct AnnealingOptions {
    const Choice& start;
    const std::vector<bool>& allowed;  ///< for each column, true if it may be chosen
    double most_energy = 0.0;          ///< limit of Choice::energy after a change, J; the start may exceed it
    int proposals = 0;                 ///< number of proposals for each group
    std::uint64_t seed = 1;
    const base::Control& control;
};
struct Annealed {
    std::vector<std::size_t> columns;  ///< column of each group in the best choice found
    long scored = 0;                   ///< number of proposals that were scored
};

/// Anneal a choice by random changes of one group. Metropolis' rule accepts changes at a falling temperature,
/// as long as the energy of the whole choice does not exceed a limit. After every change, the continuous
/// unknowns have their best values, so only the residuals that they cannot remove count. Throws Stopped.
/// @param unknowns  an orthonormal basis of the columns of SwapTable::by_unknowns; a matrix without columns
/// if there are no continuous unknowns
Annealed anneal_choice(const SwapTable& table, const Eigen::MatrixXd& unknowns,
                       const AnnealingOptions& options);

}  // namespace fretwork::design::detail
