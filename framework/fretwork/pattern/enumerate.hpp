// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/pattern/filter_catalogue.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace fretwork::pattern {

/// How many edges a pattern may have, both ends included.
struct EdgeRange {
    int least = 2;
    int most = kMaxCandidateEdges;
    /// Throws InputError unless 1 <= least <= most.
    void validate() const;
};

/// The range that the paper's table has for its own layout, 2 to 11; for any other layout, 2 to all.
EdgeRange default_edge_range(const NodeLayout& layout);

struct EnumerationOptions {
    EdgeRange edges;  ///< an upper end beyond the number of candidate edges is clipped
    FilterSettings filters{};
    int threads = 0;  ///< 0: all there are; the result and its order do not depend on it
    /// Patterns that are kept before their turn in a stream, for each of 256 pieces of the search. Less
    /// memory costs time: a piece that holds more is searched again, in parts.
    std::size_t most_kept = std::size_t{1} << 15;
    base::Control control{};  ///< receives pieces of the search; a stop throws base::Stopped
    /// Throws InputError if a value is invalid.
    void validate() const;
};

/// How many patterns there are.
struct PatternCount {
    std::vector<std::uint64_t> by_edges;  ///< entry k: those with k edges
    [[nodiscard]] std::uint64_t total() const;
};

/// Call visit(pattern) for every valid pattern, on the calling thread, in lexicographic order of their edge
/// lists (a pattern comes before those that add further edges behind its last one).
///
/// Paper, Sections 4.1 and 4.2, but filters are not applied afterwards: a search adds edges one by one and
/// turns back as soon as a rule cannot be kept any more. Memory does not grow with the number of patterns:
/// patterns that are found before their turn are kept, but at most `most_kept` of each piece.
PatternCount for_each_pattern(const NodeLayout& layout, const EnumerationOptions& options,
                              const std::function<void(const Pattern&)>& visit);

/// All valid patterns in the same order.
std::vector<Pattern> enumerate_patterns(const NodeLayout& layout, const EnumerationOptions& options = {});

/// Only how many there are: none is kept.
PatternCount count_patterns(const NodeLayout& layout, const EnumerationOptions& options = {});

}  // namespace fretwork::pattern
