// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/tiling/remeshing/rim.hpp>

#include <cstddef>
#include <vector>

namespace fretwork::tiling::detail {

/// Tests whether a point lies inside the polygons through a rim's points, at least a margin (m) away from
/// these polygons. The sides are sorted into bands across the longer side of the rim's box, and only the
/// sides near the point are tested.
class InsideTest {
  public:
    /// Sort the sides of a rim, to which the test keeps a reference. `largest_margin` (m) limits the margins
    /// of later tests. Throws base::Stopped.
    InsideTest(const Rim& rim, double largest_margin, const base::Control& control = {});
    [[nodiscard]] bool operator()(geometry::Point2 point, double margin) const;

  private:
    [[nodiscard]] std::size_t band_of(double place) const;
    [[nodiscard]] double along(geometry::Point2 point) const { return is_wide_ ? point.x : point.y; }
    [[nodiscard]] bool is_crossed(geometry::Point2 from, geometry::Point2 to, geometry::Point2 point) const;

    const Rim& rim_;
    bool is_wide_ = false;                         // the bands divide x, else y
    double low_ = 0.0;                             // start of the first band
    double band_ = 1.0;                            // width of a band
    std::vector<std::vector<std::size_t>> sides_;  // sides of each band, by their first points
};

}  // namespace fretwork::tiling::detail
