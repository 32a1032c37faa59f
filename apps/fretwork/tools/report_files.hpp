// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fretwork::app {

/// Check a table of beams, "fretwork/beams/2", which `fretwork beams --out` writes and no command reads.
/// Throws InputError with the place of an unknown key, a missing key or a value out of range.
void check_beam_table(const std::string& text, const std::string& source);

/// Check facts for making, "fretwork/facts/2" or "fretwork/facts/3", which `fretwork export --content facts`
/// writes. Throws as check_beam_table().
void check_facts(const std::string& text, const std::string& source);

}  // namespace fretwork::app
