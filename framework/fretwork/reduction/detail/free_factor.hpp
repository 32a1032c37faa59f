// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/detail/condensed_hexagon.hpp>

#include <span>

namespace fretwork::reduction::detail {

using PlaneVector = Eigen::Matrix<double, 3 * kSectors, 1>;

/// The factorized stiffness of some dofs of one plane, the others being held. L D L^T on the stack: for
/// matrices this small, more than the arithmetic itself would go into a general solver's preparations.
class FreeFactor {
  public:
    /// Keeps a view of the free dofs.
    FreeFactor(const PlaneStiffness& stiffness, std::span<const Eigen::Index> free_dofs);

    /// The displacements under a load: 0 where held. Not finite unless the stiffness is positive definite.
    [[nodiscard]] PlaneVector solve(const PlaneVector& load) const;

  private:
    /// False if a pivot is not positive.
    [[nodiscard]] bool factorize();

    std::span<const Eigen::Index> free_dofs_;
    PlaneStiffness factor_;  ///< at its top left: D, and L below it
    bool is_positive_definite_;
};

}  // namespace fretwork::reduction::detail
