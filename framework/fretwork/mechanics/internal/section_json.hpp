// SPDX-License-Identifier: GPL-3.0-or-later
// A cross-section as JSON inside frames and settings.
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/mechanics/frame/section.hpp>

namespace fretwork::mechanics {

/// Read a section, given by its type and lengths or by its numbers. Throws InputError with source and JSON
/// pointer.
Section read_section(const base::JsonReader& json);
/// The inverse of read_section(). A section is written by its type and lengths, or by its numbers if it is a
/// rectangle or its numbers are not those of its shape.
base::Json section_json(const Section& section);
/// True for a section that section_json() writes as an I shape, which files of the first formats cannot
/// contain.
bool is_of_newer_format(const Section& section);

}  // namespace fretwork::mechanics
