// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>

#include <Eigen/Core>

#include <vector>

namespace fretwork::reduction {

/// The displacements of a linear model under each scenario at a magnitude of 1 N: one row for each interface
/// node.
using UnitDisplacements = std::vector<mechanics::NodeValues>;

/// Unit displacements with derivatives: for each scenario a matrix of 6n rows (the n interface nodes, node by
/// node) and one column for each parameter.
struct UnitDisplacementsAndDerivatives {
    UnitDisplacements displacements;  ///< displacements under magnitudes of 1 N
    /// Derivatives with respect to the parameters, one matrix for each scenario.
    std::vector<Eigen::MatrixXd> derivatives;
};

/// The displacements of a tile under the setting's scenarios at a magnitude of 1 N. `stiffness` (6n x 6n) is
/// the stiffness of the tile's n interface nodes. Each side of the setting's polygon has the same number of
/// interface nodes. Throws NumericalError that names a scenario under which the tile can move freely.
UnitDisplacements unit_displacements(const Eigen::MatrixXd& stiffness, const Setting& setting);

}  // namespace fretwork::reduction
