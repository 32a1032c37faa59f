// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/detail/hexagon.hpp>

namespace fretwork::pattern::detail {

/// The smallest distance that two beams may have, for exact comparisons in the hexagon of side 1.
///
/// The squares of distances between segments are rational in this hexagon. Crossings are found by exact
/// numbers. Other distances are computed in doubles, and by exact numbers only near the limit.
class DistanceLimit {
  public:
    explicit DistanceLimit(double distance) : distance_(distance) {}
    /// True if the two centre lines come closer than the limit.
    [[nodiscard]] bool exceeds_distance(const PlacedEdge& left, const PlacedEdge& right) const;

  private:
    double distance_;
};

}  // namespace fretwork::pattern::detail
