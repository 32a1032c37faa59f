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

/// The true outline of a surface: bars with their width, merged where they meet.
struct Shape {
    std::vector<Piece> pieces;  ///< from left to right
    double height = 0.0;        ///< m
};

/// Options of the outline: fillets, kerf, and material besides the bars.
struct ShapeOptions {
    double fillet = 0.0;         ///< m, radius of inner corners; smaller if two fillets do not fit; 0: sharp
    double kerf = 0.0;           ///< m, width that the cutter removes: contours lie half of it outside the
                                 ///< material
    double frame_width = 0.0;    ///< m, width of bars along the rim; 0: none
    double bolt_diameter = 0.0;  ///< m, diameter of the holes at `bolts`; 0: none
    double eye_diameter = 0.0;   ///< m, diameter of the discs around the holes; 0: twice the
                                 ///< bolt's
    std::vector<TessellationNodeIndex> bolts{};  ///< nodes with a hole
    base::Control control{};                     ///< how the caller follows and stops the work
    /// Throws InputError that names an invalid option.
    void validate() const;

    /// The radii of the contours of a bolt's eye and of its hole, m, corrected for the kerf.
    [[nodiscard]] double eye_radius() const;
    /// M, of the line that is cut.
    [[nodiscard]] double hole_radius() const { return 0.5 * (bolt_diameter - kerf); }
    /// The radius of the fillets of the cutter's path, m.
    [[nodiscard]] double contour_fillet() const;
    /// The options of the finished part in place of the cutter's path.
    [[nodiscard]] ShapeOptions without_kerf() const;
};

/// The outline of a surface's bars: all points within half a bar's width of its centreline, so joints and
/// free ends are round. Boolean operations are exact on a grid of a nanometre, and arcs stay arcs. Throws as
/// bar_plan(), InputError for invalid options and holes that meet, and Stopped.
Shape make_shape(const simulation::Surface& surface, const ShapeOptions& options = {});
/// The outline of a plan, which has its border already.
Shape make_shape(const BarPlan& plan, const ShapeOptions& options);

/// The number of openings, between bars and for bolts.
std::size_t opening_count(const Shape& shape);
/// The area of a shape, m2.
double area(const Shape& shape);
/// The total length of all contours, m.
double cut_length(const Shape& shape);
/// The box around all of it.
geometry::Box box_of(const Shape& shape);

/// The options that could not be met everywhere, one line each: openings that the kerf closes, fillets that
/// do not fit. `left` is the finished part, made without the kerf; `cut` is the cutter's path.
std::vector<std::string> shape_remarks(const Shape& left, const Shape& cut, const ShapeOptions& options);

/// An outline and remarks about it.
struct RemarkedShape {
    Shape shape;                       ///< what is made
    std::vector<std::string> remarks;  ///< what did not fit
};
/// Make a shape with its remarks. With a kerf, it takes the time of two shapes.
RemarkedShape make_remarked_shape(const simulation::Surface& surface, const ShapeOptions& options);

}  // namespace fretwork::fabrication
