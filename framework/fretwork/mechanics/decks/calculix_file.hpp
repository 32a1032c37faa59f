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
/// GENERAL; *BOUNDARY; *CLOAD; *DLOAD with GRAV on all elements. Keywords that only control a solver or its
/// output are skipped, and so are *HEADING, *PART, *ASSEMBLY, their ends and *SOLID SECTION. Any other
/// keyword is an error. An unknown parameter of a keyword that is read is an error, too, and so are data that
/// orient beams in Abaqus: a normal at a node, and a node after an element's own nodes. Labels of nodes and
/// elements are above zero. Where a label or a set may stand, a number is a label, as in ccx, even if a set
/// has this name. Supports and loads on a set without nodes are an error.
///
/// The frame has the supports and loads at the end of the last step. The rules are from the CalculiX CrunchiX
/// User's Manual (Dhondt; *CLOAD, *BOUNDARY, *DLOAD). By default (OP=MOD), values of earlier steps stay until
/// a later step replaces them for the same node and direction. OP=NEW on the first card of a kind in a step
/// removes the values of earlier steps. Within one step, forces on one node and direction add up. The length
/// of gravity's direction vector does not matter.
///
/// All numbers are read in SI units. One number for CIRC is a radius (Abaqus); two equal numbers for CIRC are
/// diameters (CalculiX). Sections are shear-rigid, and all but GENERAL have Saint-Venant's torsion constant,
/// whereas CalculiX itself treats thick beams as solids. The direction n1 of a section, (0, 0, -1) if it is
/// not given, is the beam's local axis 3. The frame returned is valid. Throws InputError that names the
/// source and, if there is one, the line, node or element.
LabelledFrame parse_calculix(std::string_view text, const std::string& source);

/// The program that is to read a deck.
enum class DeckProgram {
    Abaqus,  ///< the deck has one B31 for each beam, and *BEAM GENERAL SECTION
    /// The deck has one B32R for each beam, and *BEAM SECTION; the middle nodes follow the frame's nodes. ccx
    /// expands these beams to solids, and includes shear and thick joints. The torsion constant of
    /// its rectangles is nearly b^3 h^3 / (3 b^2 + 3 h^2), up to 19 % more than Saint-Venant's. For squares,
    /// this is the polar second moment.
    Calculix
};

/// The text of a deck for a frame, for `program` and parse_calculix. Nodes are labelled from 1. Numbers are
/// rounded to the twenty characters of an entry, which hold at least 14 digits. Throws as validate(), and
/// InputError that names a feature of the frame if decks cannot express it: releases, divisions, shear areas,
/// a given shear modulus, and, for CalculiX, sections that are neither rectangles nor circles.
std::string calculix_text(const Frame& frame, DeckProgram program = DeckProgram::Abaqus);

/// Read a deck file. Throws as parse_calculix.
LabelledFrame read_calculix(const std::filesystem::path& path);
/// Write a deck file for DeckProgram::Abaqus atomically. Throws as calculix_text(), or IoError.
void write_calculix(const Frame& frame, const std::filesystem::path& path);

}  // namespace fretwork::mechanics
