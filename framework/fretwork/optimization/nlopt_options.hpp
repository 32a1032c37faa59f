// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

namespace fretwork::optimization {

/// What the methods of NLopt [Johnson2007] share. They work on the objective without smoothing and in the
/// unit box.
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

}  // namespace fretwork::optimization
