// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace fretwork::mechanics::sparse {

/// Pseudo-random numbers in [-1, 1), the same in every call and on every system. As starting vectors of an
/// eigenvalue search, or as a load, they have a component along every mode, but for an unlikely coincidence.
Eigen::MatrixXd arbitrary_numbers(Eigen::Index rows, Eigen::Index columns = 1);

}  // namespace fretwork::mechanics::sparse
