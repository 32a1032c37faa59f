// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/reduction/ring/ring_parameters.hpp>
#include <fretwork/reduction/unit_displacements.hpp>

#include <functional>
#include <memory>

namespace fretwork::reduction {

/// Changes of the parts of a ring with links, one column each.
using RingDirections = Eigen::Matrix<double, kRingParts, Eigen::Dynamic>;

/// A fast solver of a ring with links in the setting's hexagon: linear Euler-Bernoulli beams, in-plane and
/// out-of-plane problems solved apart, the ring eliminated by the hexagon's symmetry. Gives the displacements
/// of ring_tile under mechanics::solve_linear.
///
/// One solution for each scenario serves all magnitudes; derivatives come from the same factorization:
/// K dd = -dK d. Immutable and thread-safe.
class RingHexagon {
  public:
    /// One interface node a side, and a hexagon?
    static bool fits(const pattern::NodeLayout& layout, const Setting& setting);

    /// Throws InputError unless the setting's polygon is a hexagon and each scenario holds it.
    explicit RingHexagon(const Setting& setting);
    RingHexagon(RingHexagon&&) noexcept;
    RingHexagon& operator=(RingHexagon&&) noexcept;
    ~RingHexagon();

    /// Not finite where round-off leaves the stiffness indefinite.
    [[nodiscard]] UnitDisplacements displacements(const RingParts& parts) const;
    /// With their derivatives along some directions.
    [[nodiscard]] UnitDisplacementsAndDerivatives derivatives(const RingParts& parts,
                                                              const RingDirections& directions) const;

    /// Gives the derivatives of some function by the displacements, in their shape.
    using SlopesOf = std::function<UnitDisplacements(const UnitDisplacements&)>;
    /// The derivatives of a function of the displacements by the parts: the adjoint way, which takes one
    /// further solution a scenario, however many parts there are.
    [[nodiscard]] RingParts gradient(const RingParts& parts, const SlopesOf& slopes_of) const;

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fretwork::reduction
