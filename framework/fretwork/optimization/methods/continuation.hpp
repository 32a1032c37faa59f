// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/optimizer.hpp>

#include <vector>

namespace fretwork::optimization {

/// How a descent that smooths kinks proceeds: from well rounded to nearly the objective itself.
struct ContinuationOptions {
    std::vector<double> smoothing = {1e-1, 1e-2, 1e-3, 1e-4};  ///< stage by stage, descending
    double loose_tolerance = 1e-3;  ///< a stage but the last ends once a step gains less than this share
    double tolerance = 1e-7;        ///< the same for the last stage
    int largest_iterations = 60;    ///< of one stage
    int samples_per_start = 12;     ///< points that are tried for each descent; 1: none
    /// Throws InputError if a value is invalid.
    void validate() const;
};

}  // namespace fretwork::optimization
