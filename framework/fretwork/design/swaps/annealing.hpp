// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/swaps/swap_table.hpp>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace fretwork::design::detail {

struct AnnealingOptions {
    const Choice& start;
    const std::vector<bool>& allowed;  ///< for each column, whether it may be chosen
    double most_energy = 0.0;          ///< J, of the change; that of the start is not more
    int proposals = 0;                 ///< for each group
    std::uint64_t seed = 1;
    const base::Control& control;
};
struct Annealed {
    std::vector<std::size_t> columns;  ///< the best that was seen
    long scored = 0;                   ///< proposals that were scored
};

/// Random changes of one group, accepted by Metropolis' rule at a falling temperature as long as the energy
/// of the change stays below a limit. The continuous unknowns follow at once: only the part of the residuals
/// that no step of theirs takes away counts. Throws Stopped.
/// @param unknowns  an orthonormal basis of SwapTable::by_factors; without columns if there are none
Annealed anneal_choice(const SwapTable& table, const Eigen::MatrixXd& unknowns,
                       const AnnealingOptions& options);

}  // namespace fretwork::design::detail
