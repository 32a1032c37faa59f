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

/// The same with derivatives: for each scenario 6n rows (node by node) and one column a parameter.
struct UnitDisplacementsAndDerivatives {
    UnitDisplacements displacements;
    std::vector<Eigen::MatrixXd> derivatives;
};

/// The displacements of a tile with this stiffness of its n interface nodes (6n x 6n; as many on each side of
/// the setting's polygon) under the setting's scenarios. Throws NumericalError that names a scenario under
/// which it can move freely.
UnitDisplacements unit_displacements(const Eigen::MatrixXd& stiffness, const Setting& setting);

}  // namespace fretwork::reduction
