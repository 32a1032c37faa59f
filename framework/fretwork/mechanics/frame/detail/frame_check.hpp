// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>

#include <span>
#include <string>

namespace fretwork::mechanics::detail {

/// All of it but whether every part is held: a tile that is to be condensed is a frame without supports.
void check_parts(const Frame& frame);

/// How messages call a frame and its parts.
struct FrameNames {
    std::string source;  ///< of the frame: a file
    /// The labels of nodes, and for each beam that of its element, where the source has them: without, parts
    /// are called by their places in a frame file ("/beams/3").
    std::span<const int> node_labels{}, beam_labels{};
};

/// The checks of validate().
void check_frame(const Frame& frame, const FrameNames& names);

/// The beam's local axes at rest as the columns of a rotation: 1 along the beam, 2 = 3 x 1, 3 the normal.
/// Throws GeometryError if the beam has no length or its normal runs along it.
Eigen::Matrix3d beam_axes(const Frame& frame, const Beam& beam);

}  // namespace fretwork::mechanics::detail
