// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/detail/hexagon.hpp>

namespace fretwork::pattern::detail {

/// The smallest distance that two beams may have, for exact comparisons in the hexagon of side 1.
///
/// Squares of distances between segments are rational there. Doubles decide where they differ from the limit
/// by more than their error could be; exact numbers decide the rest.
class DistanceLimit {
  public:
    explicit DistanceLimit(double distance) : distance_(distance) {}
    /// True if the two centre lines come closer than the limit.
    [[nodiscard]] bool is_above(const PlacedEdge& left, const PlacedEdge& right) const;

  private:
    double distance_;
};

}  // namespace fretwork::pattern::detail
