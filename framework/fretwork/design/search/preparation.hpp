// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>
#include <fretwork/design/search/trials.hpp>

#include <string>
#include <vector>

namespace fretwork::design::detail {

/// The largest number of patterns for the first painting, before the rest of the palette is condensed.
inline constexpr std::size_t kFirstPatterns = 24;

/// The input of a search.
struct Preparation {
    TrialParts parts;
    std::vector<std::string> load_cases;  ///< names of the load cases
    std::vector<std::size_t> palette;     ///< candidates for groups, the most different first
    /// Coordinates of the palette's first patterns, from leading_coordinates().
    Eigen::MatrixXd coordinates;
    std::vector<DesignWarning> warnings{};  ///< warnings about goals that contradict held components
    /// The whole palette, for extend_palette(), if it has more than `first` patterns (see prepare());
    /// otherwise empty.
    std::vector<pattern::NamedPattern> whole{};
};

/// Prepare a search, and condense the candidates: as many patterns as 8,000 condensations (patterns times
/// classes of congruent tiles) allow, but at least 24. Throws InputError that names an unsuitable value;
/// Stopped.
/// @param first  the largest number of patterns to condense now; if the palette has more, this many are
/// drawn at random. Mirror images and the patterns of kept tiles are added.
Preparation prepare(const simulation::Project& project, const library::Library* library, const Target& target,
                    const DesignOptions& options, std::size_t first = static_cast<std::size_t>(-1));

/// The candidates for groups, as in Preparation.
struct ExtendedPalette {
    std::vector<std::size_t> palette;
    Eigen::MatrixXd coordinates;
};
/// Condense further candidates of the whole palette, as many as prepare() allows. The earlier candidates and
/// the most different patterns are condensed in any case; the latter are 128, or
/// DesignOptions::uniform_paintings if that is more. The indices of the earlier candidates do not change.
/// Throws Stopped.
ExtendedPalette extend_palette(Trials& trials, const std::vector<pattern::NamedPattern>& whole,
                               const DesignOptions& options);

}  // namespace fretwork::design::detail
