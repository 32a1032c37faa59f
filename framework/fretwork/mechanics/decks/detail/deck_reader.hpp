// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/decks/detail/input_deck.hpp>
#include <fretwork/mechanics/frame/frame.hpp>

namespace fretwork::mechanics::decks {

/// The frame that a deck describes; see parse_calculix().
LabelledFrame frame_of(InputDeck deck);

}  // namespace fretwork::mechanics::decks
