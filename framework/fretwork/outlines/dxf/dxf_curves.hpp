// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/detail/bezier.hpp>
#include <fretwork/outlines/dxf/dxf_file.hpp>

#include <span>

namespace fretwork::outlines::detail {

/// A curve of an entity as a polygon within the tolerance.
struct DxfCurve {
    geometry::Polygon points;  ///< metres
    enum class Ends { Open, Closed } ends = Ends::Open;
};

/// The result of drawing an entity: a curve, or the kind of an entity that is left out. Both are empty for an
/// entity that draws nothing.
struct DxfDrawn {
    std::optional<DxfCurve> curve;
    std::string left_out;
};

/// How curves become polygons. If a polyline or spline has more than `most` points, its polygon has more,
/// too, but may end early: the drawing is refused then.
struct DxfFlattening : Flattening {
    std::size_t most = 0;
};

/// Draw the first entity of `from`, with the VERTEX entities that follow it. An entity that is not parallel
/// to the drawing's plane is left out. Throws InputError with file and line if a value is missing or invalid.
/// Pre: the entity is not an INSERT.
DxfDrawn draw_dxf_entity(const DxfFile& file, std::span<const DxfEntity> from, const DxfFlattening& how);

/// The map from the coordinates of an entity to the coordinates of the drawing. An entity seen from below is
/// mirrored. Nothing if the entity is not parallel to the drawing's plane.
std::optional<Affine> dxf_orientation(const DxfFile& file, const DxfEntity& entity);

/// A rational B-spline within the tolerance; empty if no span between its knots has a length. Throws
/// InputError with the line if its numbers contradict each other.
geometry::Polygon draw_dxf_spline(const DxfFile& file, const DxfEntity& entity, const DxfFlattening& how);

}  // namespace fretwork::outlines::detail
