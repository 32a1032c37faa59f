// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/decks/detail/input_deck.hpp>
#include <fretwork/mechanics/frame/frame.hpp>

#include <string>

namespace fretwork::mechanics::decks {

/// A section of an input deck from its shape (RECT, CIRC, PIPE or GENERAL) and the line of its dimensions.
/// Throws InputError with file and line.
Section deck_section(const InputDeck& deck, const std::string& shape, const Card::Line& line);

}  // namespace fretwork::mechanics::decks
