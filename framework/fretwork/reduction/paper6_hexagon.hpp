// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/reduction/paper6_parameters.hpp>
#include <fretwork/reduction/unit_displacements.hpp>

#include <memory>

namespace fretwork::reduction {

/// A fast solver of the paper's six-parameter model in the setting's hexagon: linear Euler-Bernoulli beams,
/// in-plane and out-of-plane problems solved apart, the ring eliminated by the hexagon's symmetry. Gives the
/// displacements of paper6_tile under mechanics::solve_linear.
///
/// One solution for each scenario serves all magnitudes; derivatives (with respect to A, I2, I3, J, theta, R)
/// come from the same factorization: K dd = -dK d. Immutable and thread-safe.
class Paper6Hexagon {
  public:
    /// Throws InputError unless the setting's polygon is a hexagon and each scenario holds it.
    explicit Paper6Hexagon(const Setting& setting);
    Paper6Hexagon(Paper6Hexagon&&) noexcept;
    Paper6Hexagon& operator=(Paper6Hexagon&&) noexcept;
    ~Paper6Hexagon();

    /// Not finite where round-off leaves the stiffness indefinite.
    [[nodiscard]] UnitDisplacements displacements(const Paper6Parameters& parameters) const;
    [[nodiscard]] UnitDisplacementsAndDerivatives derivatives(const Paper6Parameters& parameters) const;

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::reduction
