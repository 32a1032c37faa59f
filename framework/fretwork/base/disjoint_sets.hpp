// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace fretwork::base {

/// Union-find over the elements 0 .. count - 1. A set is named by its smallest member, in whatever order sets
/// were united.
class DisjointSets {
  public:
    /// Make sets of one element each, numbered from 0.
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    /// Unite the sets of a and b.
    void unite(std::size_t a, std::size_t b) {
        const std::size_t one = first_of(a);
        const std::size_t other = first_of(b);
        parent_[std::max(one, other)] = std::min(one, other);
    }
    /// The smallest member of the set that contains `one`.
    [[nodiscard]] std::size_t first_of(std::size_t one) {
        while (parent_[one] != one) one = parent_[one] = parent_[parent_[one]];
        return one;
    }

  private:
    std::vector<std::size_t> parent_;
};

}  // namespace fretwork::base
