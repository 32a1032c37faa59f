// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/cut_sheet.hpp>

#include <string>
#include <vector>

namespace fretwork::fabrication {

/// The bed of a cutter, which is the size of each sheet, with the distances and fits of the parts on it.
struct Bed {
    double width = 0.0;     ///< m
    double height = 0.0;    ///< m
    double margin = 5e-3;   ///< m, free margin along the sheet's edges
    double spacing = 3e-3;  ///< m, distance between parts
    double fit = 5e-5;      ///< m, gap between the two sides of a connector
    /// Throws InputError that names an invalid option.
    void validate() const;
};

/// A surface in parts that fit a bed, nested on sheets.
///
/// Parts are groups of neighbouring tiles, separated along tile sides. Each interface node on a seam has a
/// connector: the part with the lower number has a plate with a knob, the other part a plate with the socket.
/// The connector's name is engraved on both plates.
struct SheetSet {
    std::vector<CutSheet> sheets;  ///< with the parts that are cut from each
    /// The plan of assembly: the outlines of the parts in place as guides, and the numbers of parts and tiles
    /// as labels.
    CutSheet assembly;
    std::size_t parts = 0;   ///< number of parts
    std::size_t joints = 0;  ///< number of connectors
};

/// Cut a surface into parts on sheets. Throws as make_shape(), and InputError if a tile does not fit the bed,
/// or plates of two connectors meet.
SheetSet cut_into_sheets(const simulation::Surface& surface, const ShapeOptions& options, const Bed& bed);

/// All sheets of a set side by side, with the plan of assembly above them, as one drawing.
CutSheet side_by_side(const SheetSet& set, const Bed& bed);

}  // namespace fretwork::fabrication
