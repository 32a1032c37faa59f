// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/fabrication/bar_plan.hpp>
#include <fretwork/fabrication/contour.hpp>

#include <string>
#include <vector>

namespace fretwork::fabrication {

/// Material in one piece. Contours have it on their left.
struct Piece {
    Contour outer;                  ///< counterclockwise
    std::vector<Contour> openings;  ///< clockwise; those between bars, then the holes for bolts
};

/// The true outline of a surface: bars with their width, merged where they meet.
struct Shape {
    std::vector<Piece> pieces;  ///< from left to right
    double height = 0.0;        ///< m
};

/// Material besides the bars.
struct ShapeOptions {
    double fillet = 0.0;       ///< m, radius of inner corners; smaller where two of them do not fit; 0: sharp
    double kerf = 0.0;         ///< m, width that the cutter takes away: contours lie half of it outside
    double frame_width = 0.0;  ///< m, of bars along the rim; 0: none
    double bolt_diameter = 0.0;                  ///< m, of holes at `bolts`; 0: none
    double eye_diameter = 0.0;                   ///< m, of the discs around them; 0: twice the bolt's
    std::vector<TessellationNodeIndex> bolts{};  ///< nodes with a hole
    base::Control control{};
    /// Throws InputError that names the option.
    void validate() const;

    /// The contours of a bolt's eye and of its hole, m; the cutter takes the kerf.
    [[nodiscard]] double eye_radius() const;
    [[nodiscard]] double hole_radius() const { return 0.5 * (bolt_diameter - kerf); }
    /// Radius of the fillets of the cutter's path, m.
    [[nodiscard]] double contour_fillet() const;
    /// Options of the finished part, not of the cutter's path.
    [[nodiscard]] ShapeOptions without_kerf() const;
};

/// The outline of a surface's bars: all places within half a width of a bar's line, so joints and free ends
/// are round. Exact Booleans on a grid of a nanometre; arcs are arcs. Throws as bar_plan(), InputError for
/// invalid options and holes that meet, and Stopped.
Shape make_shape(const simulation::Surface& surface, const ShapeOptions& options = {});
/// The same of a plan, which has its frame already.
Shape make_shape(const BarPlan& plan, const ShapeOptions& options);

/// Between bars, and for bolts.
std::size_t opening_count(const Shape& shape);
/// m2
double area(const Shape& shape);
/// Total length of all contours, m.
double cut_length(const Shape& shape);
geometry::Box box_of(const Shape& shape);

/// The options that could not be met everywhere, one line each: openings that the kerf closes, fillets that
/// do not fit. `left` is the finished part, made without the kerf; `cut` is the cutter's path.
std::vector<std::string> shape_remarks(const Shape& left, const Shape& cut, const ShapeOptions& options);

/// An outline and what is to be said of it.
struct RemarkedShape {
    Shape shape;
    std::vector<std::string> remarks;
};
/// make_shape() with its remarks; a kerf takes the time of a second shape.
RemarkedShape make_remarked_shape(const simulation::Surface& surface, const ShapeOptions& options);

}  // namespace fretwork::fabrication
