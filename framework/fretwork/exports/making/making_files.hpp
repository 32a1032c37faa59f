// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/bar_plan.hpp>
#include <fretwork/fabrication/cut_sheet.hpp>
#include <fretwork/fabrication/facts.hpp>
#include <fretwork/fabrication/solid.hpp>

#include <string>

namespace fretwork::exports {

/// A sheet for a laser, a mill or a plotter as DXF (R2000), in millimetres at true scale, with the layers
/// `cut`, `engrave`, `labels` and `guides`.
///
/// Each contour is a closed LWPOLYLINE with bulges in model space; $INSUNITS is millimetres.
std::string cut_dxf(const fabrication::CutSheet& sheet);
/// A sheet for a laser, a mill or a plotter as SVG: each piece is a path with true arcs, and the layers of
/// cut_dxf() are marked for Inkscape. The picture has y upwards, as in the DXF.
std::string cut_svg(const fabrication::CutSheet& sheet);

/// A solid as binary STL in millimetres, as slicers expect; the header names the unit.
std::string solid_stl(const fabrication::Solid& solid);
/// A solid as Wavefront OBJ in millimetres; the first line names the unit.
std::string solid_obj(const fabrication::Solid& solid);
/// A solid as PLY (ASCII) in millimetres; the header names the unit.
std::string solid_ply(const fabrication::Solid& solid);

/// A solid as 3MF (core specification 1.3) in millimetres, as one object. Throws IoError if the archive
/// cannot be made.
std::string solid_3mf(const fabrication::Solid& solid);
/// Bars as 3MF with a beam lattice (extension 1.1), in millimetres: each bar is round and has the area of its
/// rectangle. Throws as solid_3mf().
std::string lattice_3mf(const fabrication::BarPlan& plan);

/// The facts of a surface as a table for people, each value with its unit (mm, cm2, cm3, m, g, MPa), followed
/// by one line for each warning.
std::string facts_text(const fabrication::Facts& facts);
/// The facts of a surface as JSON, "fretwork/facts/3", SI.
std::string facts_json(const fabrication::Facts& facts);
/// The facts of a surface, and a sheet with its outline.
struct FactsOfScene {
    fabrication::Facts facts;     ///< facts for the maker
    fabrication::CutSheet sheet;  ///< outline, to which facts_html() adds the marks
};
/// The facts of a surface as a self-contained HTML page with the table and a picture that marks the warnings.
std::string facts_html(const FactsOfScene& scene);

}  // namespace fretwork::exports
