// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/decks/calculix_file.hpp>

#include <string>

namespace fretwork::mechanics::decks {

/// The text of a deck; see calculix_text().
std::string deck_text(const Frame& frame, DeckProgram program);

}  // namespace fretwork::mechanics::decks
