// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/filter_catalogue.hpp>
#include <fretwork/pattern/search/connectivity.hpp>

#include <span>
#include <vector>

namespace fretwork::pattern::detail {

/// A test that finds the rules that a graph breaks. Each rule is tested independently of the others. The test
/// refers to the filters, which must outlive it.
template <class Word>
class RuleTest {
  public:
    RuleTest(const NodeLayout& layout, std::span<const Filter> filters);

    /// One bit for each of at most 64 filters: set if the graph breaks the filter's rule.
    std::uint64_t broken(Word edges);

  private:
    /// A rule. A conflict or a cover rule also has masks.
    struct Compiled {
        const Rule* rule = nullptr;
        std::vector<Word> masks;  ///< the conflicts of each edge, or the groups
    };
    [[nodiscard]] bool breaks(const Compiled& compiled, Word edges) const;

    Quotient quotient_;
    Connectivity connectivity_;
    std::vector<Compiled> rules_;
};

extern template class RuleTest<Word64>;
extern template class RuleTest<Word128>;

}  // namespace fretwork::pattern::detail
