// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fretwork::library {

/// A search for patterns by their behaviour. Both expressions are SQL expressions. They may contain
/// FoundPatterns::columns, `pattern_id`, `mirror`, numbers, comparison, arithmetic, `between`, `in`, `like`,
/// `and`, `or`, `not`, `is null`, and SQLite's scalar functions. They may not contain comments (`--` begins
/// one) or semicolons, except in quotes.
struct PatternQuery {
    std::string where{};  ///< condition, such as `bending_poisson < 0`; empty: every pattern
    /// Expression by which the patterns are sorted; patterns without a value come last. Empty: by pattern id.
    std::string sort{};
    bool descending = false;  ///< true: the largest value of `sort` comes first
    std::size_t limit = 0;    ///< largest number of patterns; 0: any number
};

/// A pattern that a query has found.
struct FoundPattern {
    std::string id;                             ///< pattern id
    std::string mirror;                         ///< id of the mirror image; empty if the layout has none
    std::vector<std::optional<double>> values;  ///< a value for each column; none if it is not known
};

/// The patterns that a query has found, in its order.
struct FoundPatterns {
    /// Names of the columns with numbers: number of edges, smallest objective of all calibrations, and the
    /// properties in the view `behaviour` (schema.md).
    std::vector<std::string> columns;
    std::vector<FoundPattern> patterns;  ///< the patterns
    std::size_t known = 0;               ///< number of all patterns of the library with known behaviour
};

}  // namespace fretwork::library
