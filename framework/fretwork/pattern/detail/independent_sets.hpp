// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/census.hpp>
#include <fretwork/pattern/detail/random.hpp>
#include <fretwork/pattern/detail/word.hpp>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace fretwork::pattern::detail {

/// Counts by size: entry k is the number of sets with k members.
using CountsBySize = std::vector<GraphCount>;

/// The sets of edges without a conflicting pair, counted and drawn without listing them.
///
/// P(A), the counts of such sets within A, is the product over A's parts that have no conflict between them;
/// in one part, with v the edge of most conflicts, P(A) = P(A - v) + x P(A - v - conflicts of v). What has
/// been met is remembered.
template <class Word>
class IndependentSets {
  public:
    /// @param conflicts  per edge, symmetric
    /// @param most_parts  how many parts may be remembered before counting gives up
    IndependentSets(std::vector<Word> conflicts, Word edges, std::size_t most_parts);

    /// False if counting gave up; then nothing else may be called.
    [[nodiscard]] bool is_counted() const { return is_counted_; }
    /// How many sets there are of each size.
    [[nodiscard]] const CountsBySize& counts() const { return counts_; }
    /// A set of `size` members, each with the same probability. Pre: counts()[size] > 0.
    [[nodiscard]] Word draw(int size, RandomStream& random) const;

  private:
    struct WordHash {
        std::size_t operator()(Word word) const;
    };
    [[nodiscard]] Word part_of_lowest(Word edges) const;
    [[nodiscard]] int most_conflicting(Word part) const;
    CountsBySize count(Word edges);
    const CountsBySize& count_part(Word part);
    [[nodiscard]] CountsBySize known_counts(Word edges) const;
    [[nodiscard]] const CountsBySize& known_part(Word part) const { return parts_.at(part); }
    [[nodiscard]] Word draw_from_part(Word part, int size, RandomStream& random) const;
    [[nodiscard]] Word draw_from(Word edges, int size, RandomStream& random) const;

    std::vector<Word> conflicts_;
    Word edges_;
    std::size_t most_parts_;
    bool is_counted_ = true;
    std::unordered_map<Word, CountsBySize, WordHash> parts_;
    CountsBySize counts_;
};

extern template class IndependentSets<Word64>;
extern template class IndependentSets<Word128>;

}  // namespace fretwork::pattern::detail
