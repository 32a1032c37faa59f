// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

namespace fretwork::optimization {

/// What the methods of pagmo share. They have its default parameters [Biscani2020] where nothing else is
/// said, and work in the unit box.
struct PagmoOptions {
    OptimizerOptions common{};
    /// A run ends once its population differs by less, in the objective and in the variables (shares of the
    /// box).
    double tolerance = 1e-8;
    int largest_generations = 100'000;  ///< of one run
    /// Throws InputError if a value makes no sense.
    void validate() const;
};

}  // namespace fretwork::optimization
