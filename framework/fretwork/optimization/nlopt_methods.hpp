// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <memory>

namespace fretwork::optimization {

struct NloptOptions {
    OptimizerOptions common{};
    /// Relative change of the objective, and of the variables as shares of the box, at which a run ends.
    double tolerance = 1e-8;
    double initial_step = 0.1;  ///< of the local methods, as a share of the box
    /// A search that has no criterion of its own ends after so many evaluations without an improvement.
    long patience = 5000;
    /// Throws InputError if a value makes no sense.
    void validate() const;
};

/// Descents from low-discrepancy points by methods of NLopt [Johnson2007], on the objective without smoothing
/// and in the unit box: BOBYQA [Powell2009] and Subplex [Rowan1990] by values, SLSQP [Kraft1994] by
/// gradients.
std::unique_ptr<Optimizer> make_bobyqa(const NloptOptions& options);
std::unique_ptr<Optimizer> make_subplex(const NloptOptions& options);
std::unique_ptr<Optimizer> make_slsqp(const NloptOptions& options);

/// DIRECT-L of NLopt: divides the box, biased to local search [Gablonsky2001]. It ends by `patience`.
std::unique_ptr<Optimizer> make_direct_l(const NloptOptions& options);

/// Multi-level single linkage of NLopt: Sobol points, of which those far from better ones begin descents by
/// SLSQP [RinnooyKan1987, Kucherenko2005]. It ends by `patience`: the time of its clustering grows with the
/// square of the number of points.
std::unique_ptr<Optimizer> make_mlsl(const NloptOptions& options);

/// Controlled random search with local mutation of NLopt [Kaelo2006].
std::unique_ptr<Optimizer> make_crs2(const NloptOptions& options);

}  // namespace fretwork::optimization
