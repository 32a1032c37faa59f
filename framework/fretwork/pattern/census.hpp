// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/enumerate.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fretwork::pattern {

/// How many graphs there are: up to C(128, 64), which is beyond 64 bits.
__extension__ using GraphCount = unsigned __int128;

/// A count in decimal digits.
std::string count_text(GraphCount count);

/// One row: the graphs of this number of edges.
struct CensusRow {
    int edges = 0;
    GraphCount patterns = 0;  ///< all graphs of this number of candidate edges
    /// For each filter, how many of them break its rule, counted independently of the other filters; none
    /// where that cannot be counted without walking all graphs.
    std::vector<std::optional<GraphCount>> rejected;
    GraphCount valid = 0;  ///< those that keep every rule
};

/// The paper's Table 1, for any layout.
struct Census {
    std::vector<std::string> filters;  ///< the names of the columns of `rejected`
    std::vector<CensusRow> rows;
    [[nodiscard]] GraphCount valid() const;
};

/// The most candidate edges with which every graph is walked: about a million graphs.
inline constexpr int kMostEdgesWalked = 20;

/// Count what each filter rejects and what all of them leave. Up to kMostEdgesWalked candidate edges every
/// graph is walked. Beyond, valid patterns are searched for, rules about pairs, loads and groups of edges are
/// counted in closed form, and the columns of the graph rules stay empty.
Census take_census(const NodeLayout& layout, const EnumerationOptions& options = {});
/// The same after a search: `valid` is what it counted under the same options.
Census take_census(const NodeLayout& layout, const EnumerationOptions& options, const PatternCount& valid);

/// The table as CSV with LF: edges, patterns, one column for each filter, valid. Numbers that could not be
/// counted are empty.
std::string census_csv(const Census& census);

}  // namespace fretwork::pattern
