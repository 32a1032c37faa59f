// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/census.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace fretwork::pattern {

/// How many valid patterns a layout has, guessed from random trials.
struct CountEstimate {
    double valid = 0.0;  ///< the estimate: unbiased
    double lower = 0.0;  ///< with `confidence`, the number lies between these two
    double upper = 0.0;  ///< (Clopper and Pearson's interval, which errs on the safe side)
    double confidence = 0.95;
    std::uint64_t trials = 0;
    std::uint64_t hits = 0;    ///< trials that met a valid pattern
    GraphCount proposals = 0;  ///< graphs among which a trial chooses
};

/// Draws valid patterns of layouts that are too large to list, each with exactly the same probability.
///
/// A trial draws a graph uniformly among those that keep all rules about pairs of edges (crossings, angles,
/// clearances, forbidden edges) and have a wanted number of edges; these are counted exactly, so that the
/// draw is exact. The trial is kept if the graph keeps the other rules too. Every valid pattern is such a
/// graph, so what is kept is uniform over the valid patterns. Trial n depends on nothing but the seed and n.
class PatternSampler {
  public:
    /// Throws NumericalError if the layout is too large even for counting the graphs without conflicts.
    PatternSampler(const NodeLayout& layout, const EnumerationOptions& options, std::uint64_t seed);
    PatternSampler(PatternSampler&&) noexcept;
    PatternSampler& operator=(PatternSampler&&) noexcept;
    ~PatternSampler();

    /// The next `count` patterns; one may come more than once, as draws are independent. Throws
    /// NumericalError if `most_trials` trials in a row meet none.
    std::vector<Pattern> draw(std::size_t count, std::uint64_t most_trials = 100'000'000);

    /// Estimate how many valid patterns there are, from this many additional trials.
    [[nodiscard]] CountEstimate estimate(std::uint64_t trials) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::pattern
