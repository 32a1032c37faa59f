// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/detail/exact_geometry.hpp>

namespace fretwork::pattern::detail {

/// The smallest angle that two beams may enclose, for exact comparisons in the regular hexagon.
///
/// The cosine of an angle between rational directions of the hexagon has a rational square. Let q be this
/// square with the sign of the cosine; q falls as the angle grows from 0 to 180 degrees. At multiples of 30
/// and 45 degrees, the square of the limit's cosine is rational, and the comparison is exact. At any other
/// limit, the square is enclosed between two rationals 2e-41 apart. exceeds_angle() throws NumericalError if
/// q lies between them.
class AngleLimit {
  public:
    /// @param radians  the limit, from 0 to pi; a limit within 1e-12 of a multiple of 30 or 45 degrees is
    /// taken as that multiple. Throws InputError.
    explicit AngleLimit(double radians);

    /// True if the two directions enclose less than the limit. They are in affine coordinates of the base
    /// triangle.
    [[nodiscard]] bool exceeds_angle(const ExactVector& left, const ExactVector& right) const;

  private:
    ExactNumber lower_;  ///< bounds of the limit's signed cosine square
    ExactNumber upper_;
};

}  // namespace fretwork::pattern::detail
