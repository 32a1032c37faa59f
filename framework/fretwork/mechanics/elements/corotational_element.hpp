// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/corotational_element.hpp>

namespace fretwork::mechanics::elements {

/// Make a corotational element. Pre: the body has as many nodes as `nodes`. See
/// mechanics/corotational_element.hpp.
std::unique_ptr<const Element> make_corotational_element(std::vector<NodeIndex> nodes,
                                                         std::shared_ptr<const CorotationalBody> body,
                                                         const Eigen::Matrix3d& turn);

}  // namespace fretwork::mechanics::elements
