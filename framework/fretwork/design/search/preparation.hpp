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
    std::vector<std::string> load_cases;  ///< their names
    std::vector<std::size_t> palette;     ///< candidates for groups, the most different ones first
    Eigen::MatrixXd coordinates;          ///< of the palette's first members (leading_coordinates)
    std::vector<std::string> warnings{};  ///< goals for nodes that are held, one line each
};

/// Condense as many candidates as the time allows. Throws InputError that names an unsuitable value; Stopped.
Preparation prepare(const simulation::Project& project, const library::Library* library, const Target& target,
                    const DesignOptions& options);

}  // namespace fretwork::design::detail
