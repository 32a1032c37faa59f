// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/pattern/pattern.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::pattern {

enum class Symmetry {
    None,
    Mirror  ///< the pattern is its own mirror image; every pattern has the rotations of its polygon
};

/// The relations of a pattern to the others of a list.
struct PatternSameness {
    Symmetry symmetry = Symmetry::None;
    /// Position of the mirror image, if it is another pattern of the list.
    std::optional<std::size_t> mirror_partner;
    /// Patterns whose fans in the hexagon are isomorphic as graphs with coloured interface nodes have the
    /// same class, whatever their geometry. Classes are numbered from 0 by their first pattern.
    std::size_t isomorphism_class = 0;
};

struct SamenessOptions {
    int threads = 0;          ///< 0: all there are; the result does not depend on it
    base::Control control{};  ///< receives every few thousand patterns
};

struct SamenessReport {
    std::vector<PatternSameness> of_pattern;  ///< in the order of the list
    std::size_t up_to_mirror = 0;             ///< patterns, where a mirror pair counts once
    std::size_t up_to_isomorphism = 0;        ///< isomorphism classes
};

/// Find mirror images and isomorphism classes (by nauty's canonical forms) among different patterns of a
/// layout. Throws base::Stopped.
SamenessReport find_sameness(const NodeLayout& layout, std::span<const Pattern> patterns,
                             const SamenessOptions& options = {});

/// The report as CSV with LF: id, edges, symmetry (none or mirror), mirror (the partner's id, or empty),
/// class.
std::string sameness_csv(const NodeLayout& layout, std::span<const Pattern> patterns,
                         const SamenessReport& report);

}  // namespace fretwork::pattern
