// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/detail/bezier.hpp>
#include <fretwork/outlines/dxf/dxf_file.hpp>

#include <span>

namespace fretwork::outlines::detail {

/// An entity's curves, as polygons within the tolerance.
struct DxfCurve {
    geometry::Polygon points;  ///< metres
    enum class Ends { Open, Closed } ends = Ends::Open;
};

/// A curve, or why there is none: "" if the entity draws nothing, otherwise a kind for the list of what is
/// left out.
struct DxfDrawn {
    std::optional<DxfCurve> curve;
    std::string left_out;
};

/// The entity that stands first; VERTEX entities that belong to it follow. INSERT is not for this function.
DxfDrawn draw_dxf_entity(const DxfFile& file, std::span<const DxfEntity> from, const Flattening& how);

/// From the coordinates of an entity to those of the drawing: mirrored, if the entity is seen from below.
/// Nothing if it does not lie flat.
std::optional<Affine> dxf_orientation(const DxfFile& file, const DxfEntity& entity);

/// A rational B-spline within the tolerance. Throws InputError with the line if its numbers do not fit
/// together.
geometry::Polygon draw_dxf_spline(const DxfFile& file, const DxfEntity& entity, const Flattening& how);

}  // namespace fretwork::outlines::detail
