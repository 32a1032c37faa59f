// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/detail/condensed_hexagon.hpp>

#include <span>

namespace fretwork::reduction::detail {

using PlaneVector = Eigen::Matrix<double, 3 * kSectors, 1>;

/// The factorized stiffness of the free dofs of one plane; all other dofs are held. The factors L D L^T lie
/// on the stack, because a general solver's preparations take longer than the arithmetic for such small
/// matrices.
class FreeFactor {
  public:
    /// Factorize a stiffness. The object keeps a view of the free dofs.
    FreeFactor(const PlaneStiffness& stiffness, std::span<const Eigen::Index> free_dofs);

    /// The displacements under a load, zero at held dofs. The displacements are not finite unless the
    /// stiffness is positive definite.
    [[nodiscard]] PlaneVector solve(const PlaneVector& load) const;

  private:
    /// False if a pivot is not positive.
    [[nodiscard]] bool factorize();

    std::span<const Eigen::Index> free_dofs_;
    PlaneStiffness factor_;  ///< its upper left block has D on the diagonal and L below it
    bool is_positive_definite_;
};

}  // namespace fretwork::reduction::detail
