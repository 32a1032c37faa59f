// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace fretwork::mechanics::structure {

/// Which nodes hang together, by union-find.
class ConnectedNodes {
  public:
    explicit ConnectedNodes(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    void connect(std::size_t a, std::size_t b) {
        const auto [first, second] = std::minmax({first_of(a), first_of(b)});
        parent_[second] = first;
    }
    /// The first of the nodes that hang together with this one.
    std::size_t first_of(std::size_t node) {
        while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
        return node;
    }

  private:
    std::vector<std::size_t> parent_;
};

}  // namespace fretwork::mechanics::structure
