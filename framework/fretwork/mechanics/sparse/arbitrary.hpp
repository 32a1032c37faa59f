// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace fretwork::mechanics::sparse {

/// Pseudo-random numbers in [-1, 1), the same on every system. As starting vectors of an eigenvalue search,
/// these numbers have a component along every mode.
Eigen::MatrixXd arbitrary_numbers(Eigen::Index rows, Eigen::Index columns = 1);

}  // namespace fretwork::mechanics::sparse
