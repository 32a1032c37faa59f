// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sample.hpp"

namespace fretwork::mechanics::sample {

/// A cantilever of length 1 m and, hinged to its tip about axis 2, a further beam to a node at `end`. Unless
/// that node is held, the further beam swings freely.
inline Frame hinged_cantilever(const Eigen::Vector3d& end) {
    Frame frame = cantilever();
    frame.nodes.push_back(end);
    frame.beams.push_back(frame.beams[0]);
    frame.beams[1].nodes = {NodeIndex(1), NodeIndex(2)};
    frame.beams[1].releases = {{0, {{false, false, false, false, true, false}}}};
    return frame;
}

}  // namespace fretwork::mechanics::sample
