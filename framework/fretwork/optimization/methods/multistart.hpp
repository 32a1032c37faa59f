// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/methods/continuation.hpp>

namespace fretwork::optimization {

/// Many descents that follow the smoothing down together, stage by stage, from the best of sampled points.
struct MultistartOptions {
    OptimizerOptions common{};
    ContinuationOptions continuation{};
    /// If two descents are nearer than this after a stage, as a share of the bounds in every variable, the
    /// one with the larger value ends: they are in one valley. 0: all go on.
    double merging_distance = 0.01;
    /// A descent whose value after a stage is more than this multiple of the lowest one ends as well; >= 1.
    /// Infinity: none ends for its value.
    double pruning_ratio = 2.0;
    /// Throws InputError if a value is invalid.
    void validate() const;
};

}  // namespace fretwork::optimization
