// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/methods/detail/nlopt_run.hpp>
#include <fretwork/optimization/optimizer.hpp>

#include <memory>
#include <nlopt.h>
#include <optional>

namespace fretwork::optimization::detail {

/// The options that the methods of NLopt [Johnson2007] share. The methods minimize the objective without
/// smoothing, in the unit box.
struct NloptOptions {
    OptimizerOptions common{};
    /// A run ends if the relative change of the objective, or of each variable as a share of the box, is
    /// below this number.
    double tolerance = 1e-8;
    double initial_step = 0.1;  ///< initial step of the local methods, as a share of the box
    ObjectiveScale scale = ObjectiveScale::AsItIs;
    /// A search without its own criterion ends after this many evaluations without an improvement.
    long patience = 5000;
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// Runs of a method, one after the other, each from its own point of the low-discrepancy sequence and with
/// its own seed. Throws InputError if an option is invalid.
std::unique_ptr<Optimizer> make_nlopt_runs(nlopt_algorithm algorithm, const NloptOptions& options);

/// One run, from the middle of the box, of a method without its own criterion; the run ends by `patience`.
/// Throws InputError if an option is invalid.
/// @param local  the method of the run's descents, if there are any
std::unique_ptr<Optimizer> make_nlopt_search(nlopt_algorithm algorithm, std::optional<nlopt_algorithm> local,
                                             const NloptOptions& options);

}  // namespace fretwork::optimization::detail
