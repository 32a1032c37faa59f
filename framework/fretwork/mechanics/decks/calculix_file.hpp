// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace fretwork::mechanics {

/// Read the beams of a CalculiX or Abaqus input deck (.inp): *NODE; *ELEMENT of type B31, B31R, B33 (two
/// nodes), B32 or B32R (the middle node becomes a node of the frame); *NSET and *ELSET, also with GENERATE;
/// *MATERIAL with *ELASTIC and *DENSITY; *BEAM SECTION with RECT, CIRC or PIPE, *BEAM GENERAL SECTION with
/// GENERAL; *BOUNDARY; *CLOAD; *DLOAD with GRAV. What only steers a solver or its output is passed over; any
/// other keyword is refused, and so is any parameter of these that is not read.
///
/// The frame is that of the end of the last step. As the CalculiX CrunchiX User's Manual has it (Dhondt;
/// *CLOAD, *BOUNDARY, *DLOAD): what earlier steps gave stays (OP=MOD) but for what is given anew for the same
/// node and direction, or goes (OP=NEW on the first such card of a step); within one step, forces on one node
/// and direction add up. Gravity's direction counts without its length.
///
/// Numbers are taken to be in SI units. A single number for CIRC is Abaqus' radius, two equal ones are
/// CalculiX' thicknesses, diameters. Sections are shear-rigid with Saint-Venant's torsion constant, where
/// CalculiX itself takes thick beams to be solids. The direction n1 of a section is its axis 3. Throws
/// InputError with source and line, or with source and node or element; the frame is valid.
LabelledFrame parse_calculix(std::string_view text, const std::string& source);

/// Which program is to read a deck.
enum class DeckReader {
    Abaqus,   ///< one B31 for each beam, *BEAM GENERAL SECTION
    Calculix  ///< one B32R for each beam, whose middle node comes behind the frame's, and *BEAM SECTION. ccx
              ///< makes solids of them: it takes shear and thick joints into account, and torsion by the
              ///< polar second moment
};

/// The text of such a deck for a frame, nodes labelled from 1, readable by that program and by
/// parse_calculix; numbers are rounded to the twenty characters of a deck's fields, 14 digits or more.
/// Features that a deck cannot express are refused: releases, divisions, shear areas, a given shear modulus;
/// for CalculiX also sections that are neither rectangles nor circles. Throws InputError that names the
/// feature.
std::string calculix_text(const Frame& frame, DeckReader reader = DeckReader::Abaqus);

/// Throws as parse_calculix.
LabelledFrame read_calculix(const std::filesystem::path& path);
/// Throws as calculix_text, or IoError.
void write_calculix(const Frame& frame, const std::filesystem::path& path);

}  // namespace fretwork::mechanics
