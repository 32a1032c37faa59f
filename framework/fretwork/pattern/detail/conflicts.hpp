// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/pattern.hpp>

#include <utility>
#include <vector>

namespace fretwork::pattern::detail {

/// Collects the pairs of a ConflictRule.
class ConflictTable {
  public:
    explicit ConflictTable(const NodeLayout& layout) : conflicts_(layout.candidate_edges().size()) {}

    void add(EdgeIndex left, EdgeIndex right) {
        conflicts_[left].set(right);
        conflicts_[right].set(left);
    }
    base::IndexVector<EdgeIndex, Pattern::Bits> take() { return std::move(conflicts_); }

  private:
    base::IndexVector<EdgeIndex, Pattern::Bits> conflicts_;
};

}  // namespace fretwork::pattern::detail
