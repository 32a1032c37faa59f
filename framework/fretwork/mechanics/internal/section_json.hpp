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
/// The inverse of read_section. A rectangle is written by its numbers, and any other shape by its type.
base::Json section_json(const Section& section);
/// True if files of the first formats cannot contain this section, an I shape.
bool is_of_newer_format(const Section& section);

}  // namespace fretwork::mechanics
