// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace fretwork::mechanics::sparse {

/// Numbers in [-1, 1) without pattern, the same on every system: a start that no mode is missing from.
Eigen::MatrixXd arbitrary_numbers(Eigen::Index rows, Eigen::Index columns = 1);

}  // namespace fretwork::mechanics::sparse
