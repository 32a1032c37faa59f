// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/census.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace fretwork::pattern {

/// The number of valid patterns of a layout, estimated from random trials.
struct CountEstimate {
    double valid = 0.0;  ///< the unbiased estimate
    double lower = 0.0;  ///< with probability `confidence`, the true number lies between lower and upper
    double upper = 0.0;  ///< (Clopper and Pearson's interval, which is never too narrow)
    double confidence = 0.95;  ///< of the interval
    std::uint64_t trials = 0;  ///< graphs that were drawn
    std::uint64_t hits = 0;    ///< trials that drew a valid pattern
    GraphCount proposals = 0;  ///< the number of graphs that a trial draws from
};

/// Draws valid patterns of layouts that are too large to list, each with exactly the same probability.
///
/// A trial draws a graph uniformly among those that keep all rules about pairs of edges (crossings, angles,
/// clearances, forbidden edges) and have an allowed number of edges. These graphs are counted exactly, so the
/// draw is exactly uniform. A graph that breaks another rule is rejected. Every valid pattern is one of these
/// graphs, so the valid patterns are drawn uniformly, too. Trial n depends on the seed and n alone.
class PatternSampler {
  public:
    /// Throws NumericalError if the layout is too large to count even the graphs without conflicts.
    PatternSampler(const NodeLayout& layout, const EnumerationOptions& options, std::uint64_t seed);
    PatternSampler(PatternSampler&&) noexcept;
    PatternSampler& operator=(PatternSampler&&) noexcept;
    ~PatternSampler();

    /// The next `count` patterns. Draws are independent, so a pattern may be drawn more than once. Throws
    /// NumericalError if `most_trials` trials in a row find no valid pattern.
    std::vector<Pattern> draw(std::size_t count, std::uint64_t most_trials = 100'000'000);

    /// Estimate the number of valid patterns from `trials` additional trials.
    [[nodiscard]] CountEstimate estimate(std::uint64_t trials) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::pattern
