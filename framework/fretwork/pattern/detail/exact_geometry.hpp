// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace fretwork::pattern::detail {

using ExactNumber = CGAL::Exact_rational;
/// Affine coordinates of the base triangle: v0 is the origin, v1 = (1, 0), v2 = (0, 1). Crossing and
/// collinearity are affine invariants, so a result in these coordinates holds in every triangle.
using ExactKernel = CGAL::Simple_cartesian<ExactNumber>;
using ExactPoint = ExactKernel::Point_2;
using ExactVector = ExactKernel::Vector_2;

inline ExactNumber exact(const Rational& number) {
    return ExactNumber(number.numerator()) / ExactNumber(number.denominator());
}

inline ExactPoint exact_point(const LayoutNode& node) {
    return {exact(node.place[1]), exact(node.place[2])};
}

/// True if `point` lies on the segment between `first` and `second` and is neither of them.
inline bool is_strictly_between(const ExactPoint& point, const ExactPoint& first, const ExactPoint& second) {
    return point != first && point != second && CGAL::collinear(first, point, second) &&
           CGAL::collinear_are_ordered_along_line(first, point, second);
}

}  // namespace fretwork::pattern::detail
