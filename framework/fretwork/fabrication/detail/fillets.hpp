// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/contour.hpp>

namespace fretwork::fabrication::detail {

/// Round the inner corners of the material, which lies on the left: those between two straight lines where
/// the contour turns right. The radius (m) is smaller where two arcs would meet on a line.
Contour with_fillets(const Contour& contour, double radius);

}  // namespace fretwork::fabrication::detail
