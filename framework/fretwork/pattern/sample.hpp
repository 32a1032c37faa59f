// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/census.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace fretwork::pattern {

/// The number of valid patterns of a layout, estimated from random trials.
struct CountEstimate {
    double valid = 0.0;  ///< unbiased estimate of the number
    double lower = 0.0;  ///< lower end of the confidence interval
    /// Upper end of the confidence interval (Clopper and Pearson's, which is never too narrow).
    double upper = 0.0;
    double confidence = 0.95;  ///< probability that the interval contains the true number
    std::uint64_t trials = 0;  ///< number of trials; each draws one graph
    std::uint64_t hits = 0;    ///< number of trials that drew a valid pattern
    GraphCount proposals = 0;  ///< number of graphs from which a trial draws
};

/// Draws valid patterns of layouts that have too many to list. All valid patterns have exactly the same
/// probability.
///
/// A trial draws a graph from the proposals: all graphs that keep all rules about pairs of edges (crossings,
/// angles, clearances, forbidden edges) and have an allowed number of edges. The proposals are counted
/// exactly, so all have exactly the same probability. A proposal that breaks another rule is rejected. Every
/// valid pattern is a proposal, so all valid patterns have the same probability, too. Trial n depends on the
/// seed and n alone.
class PatternSampler {
  public:
    /// Count the proposals. Throws NumericalError if the layout is too large for this count, and as
    /// for_each_pattern().
    PatternSampler(const NodeLayout& layout, const EnumerationOptions& options, std::uint64_t seed);
    PatternSampler(PatternSampler&&) noexcept;
    PatternSampler& operator=(PatternSampler&&) noexcept;
    ~PatternSampler();

    /// The next `count` patterns. Draws are independent, so a pattern may be drawn more than once. Throws
    /// NumericalError if there are no proposals, or if `most_trials` trials in a row (rounded up to a
    /// multiple of 4096) find no valid pattern. Throws Stopped.
    std::vector<Pattern> draw(std::size_t count, std::uint64_t most_trials = 100'000'000);

    /// Estimate the number of valid patterns from the first `trials` trials, whatever was drawn before.
    /// Throws InputError if `trials` is 0, and Stopped.
    [[nodiscard]] CountEstimate estimate(std::uint64_t trials) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::pattern
