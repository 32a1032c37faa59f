// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/solution.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/reduction/setting.hpp>

#include <string>
#include <vector>

namespace fretwork::reduction {

/// What the interface nodes of a tile do under one scenario, at its magnitudes k = 1, 2, ..
struct Response {
    struct Sample {
        int step = 0;                         ///< k
        double magnitude = 0.0;               ///< N
        mechanics::NodeValues displacements;  ///< one row for each interface node; not converged: zeros
        bool converged = true;
        bool stable = true;
    };
    std::string scenario;
    std::vector<Sample> samples;
};

/// The pattern's full model in the setting's polygon, without supports and loads; interface node i is node i.
mechanics::Frame pattern_frame(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                               const Setting& setting);

/// The nonlinear responses of a pattern, one for each scenario of the setting. Paper, Eq. (2).
std::vector<Response> compute_responses(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                                        const Setting& setting);

}  // namespace fretwork::reduction
