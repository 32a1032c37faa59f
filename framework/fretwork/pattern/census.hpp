// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/enumerate.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fretwork::pattern {

/// A count of graphs. 128 candidate edges give up to 2^128 - 1 graphs, whose number needs 128 bits.
__extension__ using GraphCount = unsigned __int128;

/// The decimal digits of a count.
std::string count_text(GraphCount count);

/// A row of the census: the graphs with one number of edges.
struct CensusRow {
    int edges = 0;            ///< number of edges
    GraphCount patterns = 0;  ///< number of all graphs with this number of edges, valid or not
    /// For each filter, the number of graphs that it rejects, whether or not other filters reject them, too.
    /// An entry is empty if the layout has more than kMostEdgesWalked candidate edges and the graphs cannot
    /// be counted without walking them.
    std::vector<std::optional<GraphCount>> rejected;
    GraphCount valid = 0;  ///< number of graphs that all filters accept
};

/// The paper's Table 1, for any layout.
struct Census {
    std::vector<std::string> filters;  ///< the names of the columns of `rejected`
    std::vector<CensusRow> rows;       ///< one for each number of edges
    /// The number of valid graphs in all rows together.
    [[nodiscard]] GraphCount valid() const;
};

/// The largest number of candidate edges for which a census walks every graph: 20 edges make a million
/// graphs.
inline constexpr int kMostEdgesWalked = 20;

/// Count the graphs that each filter rejects, and the valid graphs, which all filters accept. Up to
/// kMostEdgesWalked candidate edges, every graph is walked. With more candidate edges, a search counts the
/// valid graphs. For filters about pairs, loads and groups of edges, the rejected graphs are counted without
/// walking them, unless that takes too much memory or time. All other columns stay empty. Throws as
/// for_each_pattern().
Census take_census(const NodeLayout& layout, const EnumerationOptions& options = {});
/// Take the census with the `valid` counts of an earlier search under the same options. The counts are
/// ignored if every graph is walked. Throws as for_each_pattern().
Census take_census(const NodeLayout& layout, const EnumerationOptions& options, const PatternCount& valid);

/// The census as CSV with LF. Columns: edges, patterns, one for each filter, valid. An entry is empty if it
/// could not be counted.
std::string census_csv(const Census& census);

}  // namespace fretwork::pattern
