// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/pattern/pattern.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::pattern {

/// The symmetries of a pattern's fan other than its rotations. Every fan in a regular polygon has the
/// rotations of that polygon.
enum class Symmetry {
    None,   ///< the fan has no symmetry other than its rotations
    Mirror  ///< the pattern is its own mirror image
};

/// The relations of a pattern to the other patterns of a list.
struct PatternSameness {
    Symmetry symmetry = Symmetry::None;  ///< symmetry of the pattern's fan
    /// The position of the pattern's mirror image in the list; none if the mirror image is the pattern itself
    /// or is not in the list.
    std::optional<std::size_t> mirror_partner;
    /// Two patterns have the same class if their fans in the hexagon are isomorphic as graphs with coloured
    /// interface nodes, whatever their geometry. Classes are numbered from 0 in the order of their first
    /// patterns.
    std::size_t isomorphism_class = 0;
};

/// Options of find_sameness().
struct SamenessOptions {
    /// Number of threads; 0: one for each processor; the result does not depend on the number.
    int threads = 0;
    base::Control control{};  ///< progress is reported every few thousand patterns
};

/// The mirror pairs and isomorphism classes of a list of patterns.
struct SamenessReport {
    std::vector<PatternSameness> of_pattern;  ///< one entry for each pattern, in the order of the list
    std::size_t up_to_mirror = 0;             ///< number of patterns if a mirror pair counts once
    std::size_t up_to_isomorphism = 0;        ///< number of isomorphism classes
};

/// Find mirror images and isomorphism classes (by nauty's canonical forms) in a list of distinct patterns of
/// one layout. Throws base::Stopped.
SamenessReport find_sameness(const NodeLayout& layout, std::span<const Pattern> patterns,
                             const SamenessOptions& options = {});

/// The report as CSV with LF. Columns: id, edges, symmetry (none or mirror), mirror (the partner's id, or
/// empty), class.
std::string sameness_csv(const NodeLayout& layout, std::span<const Pattern> patterns,
                         const SamenessReport& report);

}  // namespace fretwork::pattern
