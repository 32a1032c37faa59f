// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/cut_sheet.hpp>

#include <string>
#include <vector>

namespace fretwork::fabrication {

/// The sheets that a cutter takes, and how parts fit together.
struct Bed {
    double width = 0.0;     ///< m
    double height = 0.0;    ///< m
    double margin = 5e-3;   ///< m, left free along its edges
    double spacing = 3e-3;  ///< m, between parts
    double fit = 5e-5;      ///< m, gap that stays between the two sides of a joint
    /// Throws InputError.
    void validate() const;
};

/// A surface in parts that fit a bed, nested on sheets.
///
/// Parts are groups of neighbouring tiles, cut apart along tile sides. At each interface node on a seam the
/// part of the lower number has a plate with a knob, and the other one a plate with the socket for it; both
/// plates have the joint's name engraved.
struct SheetSet {
    std::vector<CutSheet> sheets;
    /// Where the parts go: their outlines in place as guides, with the numbers of parts, and the tiles' as
    /// labels.
    CutSheet assembly;
    std::size_t parts = 0;
    std::size_t joints = 0;
};

/// Throws as make_shape(), and InputError if a tile does not fit the bed, or plates of two joints meet.
SheetSet cut_into_sheets(const simulation::Surface& surface, const ShapeOptions& options, const Bed& bed);

/// All sheets of a set beside each other, with the assembly above them: one drawing for one file.
CutSheet side_by_side(const SheetSet& set, const Bed& bed);

}  // namespace fretwork::fabrication
