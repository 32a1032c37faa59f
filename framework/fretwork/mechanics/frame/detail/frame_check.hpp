// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace fretwork::mechanics::detail {

/// Check a frame as validate() does, except that connected parts need no support, because a tile to be
/// condensed is a frame without supports.
void check_parts(const Frame& frame);

/// A number of a section or a material that is out of its limits.
struct PropertyFlaw {
    const char* key;      ///< key of the number in files
    std::string problem;  ///< "is 1e+300, where a number from 1e-24 to 1e+24 (m^2) is needed"
};
/// The first flaw of a section; none if all its numbers are within their limits.
std::optional<PropertyFlaw> flaw_of(const Section& section);
/// The first flaw of a material; none if all its numbers are within their limits.
std::optional<PropertyFlaw> flaw_of(const Material& material);

/// The names of a frame, its nodes and its beams in messages.
struct FrameNames {
    std::string source;  ///< name of the frame, such as a file
    /// The labels of the nodes, and for each beam the label of its element, if the source has labels. Without
    /// labels, nodes and beams are named by their places in a frame file ("/beams/3").
    std::span<const int> node_labels{}, beam_labels{};
    /// For each prescribed component, the position of its entry in the source, which may prescribe several.
    /// Empty: each component has an entry of its own.
    std::span<const std::size_t> prescribed_entries{};
};

/// Check a frame as validate() does, with these names in messages.
void check_frame(const Frame& frame, const FrameNames& names);

/// The beam's local axes at rest as the columns of a rotation: 1 along the beam, 2 = 3 x 1, 3 the normal.
/// Throws GeometryError if the beam has no length or its normal runs along it.
Eigen::Matrix3d beam_axes(const Frame& frame, const Beam& beam);

}  // namespace fretwork::mechanics::detail
