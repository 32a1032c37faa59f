// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <vector>

namespace fretwork::optimization::detail {

/// The points of the low-discrepancy sequence from which descents begin: of `samples` points those
/// `options.starts` with the best values, best first; with no more samples than starts, the first points,
/// unevaluated. Empty if the budget does not pay for a single sample.
std::vector<Eigen::VectorXd> choose_starts(Evaluator& evaluator, const OptimizerOptions& options,
                                           int samples);

}  // namespace fretwork::optimization::detail
