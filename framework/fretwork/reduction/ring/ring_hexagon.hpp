// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/reduction/ring/ring_parameters.hpp>
#include <fretwork/reduction/unit_displacements.hpp>

#include <functional>
#include <memory>

namespace fretwork::reduction {

/// Directions in the space of RingParts, one in each column.
using RingDirections = Eigen::Matrix<double, kRingParts, Eigen::Dynamic>;

/// A fast solver for a ring with links in the setting's hexagon. The beams are linear Euler-Bernoulli beams.
/// The solver treats the in-plane and out-of-plane problems separately and eliminates the ring by the
/// hexagon's symmetry. The displacements equal those of ring_tile() by mechanics::solve_linear().
///
/// One solution for each scenario serves all magnitudes. The derivatives dd of the displacements d follow
/// from the same factorization: K dd = -dK d. A RingHexagon is immutable and thread-safe.
class RingHexagon {
  public:
    /// True if the setting's polygon is a hexagon and the layout has one interface node on each side.
    static bool fits(const pattern::NodeLayout& layout, const Setting& setting);

    /// Prepare a solver for a setting. Throws InputError unless the setting is valid, its polygon is a
    /// hexagon, and each scenario has enough supports.
    explicit RingHexagon(const Setting& setting);
    RingHexagon(RingHexagon&&) noexcept;
    RingHexagon& operator=(RingHexagon&&) noexcept;
    ~RingHexagon();

    /// The displacements of the ring with links. The displacements are not finite if round-off makes the
    /// stiffness indefinite.
    [[nodiscard]] UnitDisplacements displacements(const RingParts& parts) const;
    /// The displacements and their derivatives along the given directions.
    [[nodiscard]] UnitDisplacementsAndDerivatives derivatives(const RingParts& parts,
                                                              const RingDirections& directions) const;

    /// A function that returns the derivatives of another function with respect to the displacements, in the
    /// shape of the displacements.
    using SlopesOf = std::function<UnitDisplacements(const UnitDisplacements&)>;
    /// The derivatives of a function of the displacements with respect to the ring's parts, by the adjoint
    /// method: one further solution for each scenario, whatever the number of parts.
    [[nodiscard]] RingParts gradient(const RingParts& parts, const SlopesOf& slopes_of) const;

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::reduction
