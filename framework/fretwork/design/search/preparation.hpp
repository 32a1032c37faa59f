// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>
#include <fretwork/design/search/trials.hpp>

#include <string>
#include <vector>

namespace fretwork::design::detail {

/// The input of a search.
struct Preparation {
    TrialParts parts;
    std::vector<std::string> load_cases;  ///< names of the load cases
    std::vector<std::size_t> palette;     ///< candidates for groups; the most different candidates come first
    /// Coordinates of the palette's first members, from leading_coordinates().
    Eigen::MatrixXd coordinates;
    std::vector<std::string> warnings{};  ///< warnings, one line each, about goals for nodes that are held
};

/// Prepare a search, and condense as many candidates as the time allows. Throws InputError that names an
/// unsuitable value; Stopped.
Preparation prepare(const simulation::Project& project, const library::Library* library, const Target& target,
                    const DesignOptions& options);

}  // namespace fretwork::design::detail
