// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>

namespace fretwork::mechanics::structure {

/// The dofs of the membrane problem and of the bending problem. A flat structure with elements that decouple
/// splits into these two problems, with three dofs at each node.
inline constexpr DofSet kInPlane = {{true, true, false, false, false, true}};
inline constexpr DofSet kOutOfPlane = {{false, false, true, true, true, false}};

/// True if all nodes have the same z.
bool is_flat(const Assembly& assembly);

/// True if an element's stiffness does not couple motions in the plane with motions out of the plane, up to
/// rounding.
bool decouples(const Eigen::MatrixXd& stiffness);

}  // namespace fretwork::mechanics::structure
