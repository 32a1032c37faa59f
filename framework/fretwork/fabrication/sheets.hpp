// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/cut_sheet.hpp>

#include <string>
#include <vector>

namespace fretwork::fabrication {

/// The bed of a cutter: the size of each sheet, and the distances and fits of the parts on a sheet.
struct Bed {
    double width = 0.0;     ///< m, at least 1e-3
    double height = 0.0;    ///< m, at least 1e-3
    double margin = 5e-3;   ///< free margin along the sheet's edges, m
    double spacing = 3e-3;  ///< distance between parts, m
    double fit = 5e-5;      ///< gap between the two sides of a connector, m
    /// Throws InputError that names an invalid option.
    void validate() const;
};

/// A surface in parts that fit a bed, nested on sheets.
///
/// A part is a group of neighbouring tiles; tile sides separate it from other parts. Each interface node
/// between two parts has a connector: the part with the lower number has a plate with a knob, and the other
/// part has a plate with a socket. The connector's number is engraved on both plates.
struct SheetSet {
    std::vector<CutSheet> sheets;  ///< sheets with the parts to cut from each
    /// The plan of assembly: the outlines of the parts at their places as guides, and the numbers of parts,
    /// tiles and connectors as labels.
    CutSheet assembly;
    std::size_t parts = 0;       ///< number of parts
    std::size_t connectors = 0;  ///< number of connectors
    /// Remarks as shape_remarks(): on openings of the parts that the kerf closes, and on fillets of the whole
    /// outline that do not fit.
    std::vector<std::string> remarks{};
};

/// Cut a surface into parts on sheets. With a kerf, this takes the time of two sets. Throws as make_shape().
/// Throws InputError if `bed` is invalid, if a tile does not fit the bed, or if a connector's plate meets
/// another plate, an end of its tile side or a hole for a bolt.
SheetSet cut_into_sheets(const simulation::Surface& surface, const ShapeOptions& options, const Bed& bed);

/// All sheets of a set side by side, with the plan of assembly above them, as one drawing.
CutSheet side_by_side(const SheetSet& set, const Bed& bed);

}  // namespace fretwork::fabrication
