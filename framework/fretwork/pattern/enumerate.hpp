// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/pattern/filter_catalogue.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace fretwork::pattern {

/// The range of the number of edges of a pattern, both ends included.
struct EdgeRange {
    int least = 2;                  ///< smallest number of edges
    int most = kMaxCandidateEdges;  ///< largest number of edges
    /// Throws InputError unless 1 <= least <= most.
    void validate() const;
};

/// The default range: 2 to 11 for the paper's layout, as in the paper's table; 2 to all for any other layout,
/// or 1 to 1 if it has only one candidate edge.
EdgeRange default_edge_range(const NodeLayout& layout);

/// Options of the enumeration.
struct EnumerationOptions {
    /// Numbers of edges of the patterns; an upper end beyond the number of candidate edges is clipped.
    EdgeRange edges;
    FilterSettings filters{};  ///< the rules that valid patterns keep
    /// Number of threads; 0: one for each processor; the result and its order do not depend on the number.
    int threads = 0;
    /// The search takes its pieces in batches of 256. Each piece of a batch stores at most this number of
    /// patterns until they are passed on in order. A smaller number saves memory but costs time: a piece with
    /// more patterns is divided and searched again.
    std::size_t most_kept = std::size_t{1} << 15;
    base::Control control{};  ///< progress counts pieces of the search; a stop throws base::Stopped
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// The number of patterns, by their number of edges.
struct PatternCount {
    std::vector<std::uint64_t> by_edges;  ///< entry k: number of patterns with k edges
    /// The sum over all numbers of edges.
    [[nodiscard]] std::uint64_t total() const;
};

/// Call visit(pattern) for every valid pattern, on the calling thread, in lexicographic order of the
/// patterns' edge lists. A pattern comes before all patterns that extend its list.
///
/// Paper, Sections 4.1 and 4.2, with one difference: filters are not applied afterwards. Instead, a search
/// adds edges one by one and turns back as soon as a rule that prunes (see rule.hpp) can no longer be kept.
/// Memory does not grow with the number of patterns: see EnumerationOptions::most_kept. Returns the count.
/// Throws InputError if an option is invalid, NumericalError as make_filters(), and Stopped.
PatternCount for_each_pattern(const NodeLayout& layout, const EnumerationOptions& options,
                              const std::function<void(const Pattern&)>& visit);

/// All valid patterns in the order of for_each_pattern. Throws as for_each_pattern().
std::vector<Pattern> enumerate_patterns(const NodeLayout& layout, const EnumerationOptions& options = {});

/// Count the valid patterns without keeping any. Throws as for_each_pattern().
PatternCount count_patterns(const NodeLayout& layout, const EnumerationOptions& options = {});

}  // namespace fretwork::pattern
