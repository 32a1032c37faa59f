// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/fabrication/bar_plan.hpp>
#include <fretwork/fabrication/contour.hpp>

#include <string>
#include <vector>

namespace fretwork::fabrication {

/// A connected piece of material, on the left of its contours.
struct Piece {
    Contour outer;                  ///< counterclockwise
    std::vector<Contour> openings;  ///< clockwise; first the openings between bars, then the holes for bolts
};

/// The true outline of a surface: the area of all bars, merged where they meet.
struct Shape {
    std::vector<Piece> pieces;  ///< pieces, sorted from left to right
    double height = 0.0;        ///< m
};

/// Options of the outline: fillets, kerf, and material besides the bars.
struct ShapeOptions {
    /// Radius of inner corners, m; it is smaller where two fillets do not fit; 0: sharp corners.
    double fillet = 0.0;
    /// Width that the cutter removes, m; contours lie half this width outside the material.
    double kerf = 0.0;
    double frame_width = 0.0;    ///< width of bars along the rim, m; 0: no bars along the rim
    double bolt_diameter = 0.0;  ///< diameter of the holes at `bolts`, m; 0: no holes
    double eye_diameter = 0.0;   ///< diameter of the discs around the holes, m; 0: twice `bolt_diameter`
    std::vector<TessellationNodeIndex> bolts{};  ///< nodes with a hole for a bolt; a bar ends at each of them
    base::Control control{};                     ///< progress and stop
    /// Throws InputError that names an invalid option.
    void validate() const;

    /// The radius of the contour of a bolt's eye, m, corrected for the kerf.
    [[nodiscard]] double eye_radius() const;
    /// The radius of the contour of a bolt's hole, m, corrected for the kerf.
    [[nodiscard]] double hole_radius() const { return 0.5 * (bolt_diameter - kerf); }
    /// The radius of the contours' fillets, m, corrected for the kerf.
    [[nodiscard]] double contour_fillet() const;
    /// The same options with a kerf of 0, for the finished part instead of the cutter's path.
    [[nodiscard]] ShapeOptions without_kerf() const;
};

/// Make the outline of a surface's bars: all points within half a bar's width of its centreline, so joints
/// and free ends are round. Boolean operations are exact on a grid of a nanometre, and arcs stay arcs. Throws
/// as bar_plan(), InputError for invalid options, bars narrower than some micrometres, holes that meet and
/// holes where no bar ends, and Stopped.
Shape make_shape(const simulation::Surface& surface, const ShapeOptions& options = {});
/// Make the outline of a plan. The plan contains its border, so `options.frame_width` is only validated.
/// Throws as the other make_shape(), but not as bar_plan().
Shape make_shape(const BarPlan& plan, const ShapeOptions& options);

/// The number of openings between bars and for bolts.
std::size_t opening_count(const Shape& shape);
/// The area of a shape, m2.
double area(const Shape& shape);
/// The total length of all contours, m.
double cut_length(const Shape& shape);
/// The box around all pieces. Pre: there is at least one piece.
geometry::Box box_of(const Shape& shape);

/// Remarks, one line each, about options that could not be met everywhere: openings that the kerf closes, and
/// fillets that do not fit. `left` is the finished part, made without the kerf; `cut` is the cutter's path.
std::vector<std::string> shape_remarks(const Shape& left, const Shape& cut, const ShapeOptions& options);

/// An outline and remarks about it.
struct RemarkedShape {
    Shape shape;                       ///< the outline
    std::vector<std::string> remarks;  ///< remarks about options that could not be met
};
/// Make a shape with its remarks. With a kerf, this takes the time of two shapes. Throws as make_shape().
RemarkedShape make_remarked_shape(const simulation::Surface& surface, const ShapeOptions& options);

}  // namespace fretwork::fabrication
