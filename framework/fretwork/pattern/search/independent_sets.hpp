// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/pattern/census.hpp>
#include <fretwork/pattern/search/wide_random.hpp>
#include <fretwork/pattern/search/word.hpp>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace fretwork::pattern::detail {

/// Numbers of sets by size: entry k is the number of sets with k members.
using CountsBySize = std::vector<GraphCount>;

/// The sets of edges without a conflicting pair, counted and drawn without listing them.
///
/// Let the coefficients of the polynomial P(A) be the numbers of such sets, by size, within a set A of edges.
/// If A falls into parts without a conflict between two parts, P(A) is the product of the parts' polynomials.
/// If A is one part, P(A) = P(A - v) + x P(A - v - conflicts of v), where v is the edge with the most
/// conflicts. P(A) is cached by A.
template <class Word>
class IndependentSets {
  public:
    /// @param conflicts  the edges in conflict with each edge; symmetric
    /// @param most_parts  the largest number of parts that are stored before counting gives up
    ///
    /// Throws Stopped.
    IndependentSets(std::vector<Word> conflicts, Word edges, std::size_t most_parts,
                    const base::Control& control = {});

    /// False if counting gave up; in this case, no other function may be called.
    [[nodiscard]] bool is_counted() const { return is_counted_; }
    /// The number of sets of each size.
    [[nodiscard]] const CountsBySize& counts() const { return all_.tails.front(); }
    /// Draw a set of `size` members; all sets of this size have the same probability. Pre: counts()[size] >
    /// 0.
    [[nodiscard]] Word draw(int size, WideRandom& random) const;

  private:
    /// Parts without a conflict between two parts. `tails[i]` has the numbers of sets within the parts from i
    /// on.
    struct Forest {
        std::vector<std::size_t> parts;
        std::vector<CountsBySize> tails;
    };
    /// A part, divided by its edge with the most conflicts.
    struct Part {
        int edge = 0;
        Forest without;  ///< the rest of the part if the edge is not chosen
        Forest with;     ///< the rest of the part if the edge is chosen
        CountsBySize counts;
    };
    struct WordHash {
        std::size_t operator()(Word word) const;
    };
    [[nodiscard]] Word part_of_lowest(Word edges) const;
    [[nodiscard]] int most_conflicting(Word part) const;
    Forest make_forest(Word edges, const base::Control& control);
    std::size_t make_part(Word edges, const base::Control& control);
    [[nodiscard]] Word draw_from(const Forest& forest, int size, WideRandom& random) const;
    [[nodiscard]] Word draw_from(const Part& part, int size, WideRandom& random) const;

    std::vector<Word> conflicts_;
    std::size_t most_parts_;
    bool is_counted_ = true;
    std::vector<Part> parts_;
    /// Index in `parts_` of each part counted so far.
    std::unordered_map<Word, std::size_t, WordHash> numbers_;
    Forest all_;
};

extern template class IndependentSets<Word64>;
extern template class IndependentSets<Word128>;

}  // namespace fretwork::pattern::detail
