// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>
#include <fretwork/design/search/trials.hpp>

#include <string>
#include <vector>

namespace fretwork::design::detail {

/// What a search starts from.
struct Preparation {
    TrialParts parts;
    std::vector<std::string> load_cases;  ///< their names
    std::vector<std::size_t> palette;     ///< candidates that groups may have, the most different ones first
};

/// Condense the candidates that there is time for. Throws InputError that names what does not fit, and
/// Stopped.
Preparation prepare(const simulation::Project& project, const library::Library* library, const Target& target,
                    const DesignOptions& options);

}  // namespace fretwork::design::detail
