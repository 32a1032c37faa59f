// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/nlopt_options.hpp>

#include <memory>
#include <nlopt.h>
#include <optional>

namespace fretwork::optimization::detail {

/// Runs one after the other, each from its own point of the low-discrepancy sequence and with a seed of its
/// own. Throws InputError if an option makes no sense.
std::unique_ptr<Optimizer> make_nlopt_runs(nlopt_algorithm algorithm, const NloptOptions& options);

/// One run from the middle of the box of a method that has no criterion of its own, and ends by `patience`.
/// `local`: the method by which it descends, if it does. Throws InputError if an option makes no sense.
std::unique_ptr<Optimizer> make_nlopt_search(nlopt_algorithm algorithm, std::optional<nlopt_algorithm> local,
                                             const NloptOptions& options);

}  // namespace fretwork::optimization::detail
