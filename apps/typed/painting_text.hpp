// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/project/painting_choice.hpp>

#include <string>

namespace fretwork::typed {

/// How tiles are to be painted, as people write it.
struct PaintingText {
    /// One pattern's id, a painting file, `random:SEED`, `field:EXPRESSION`, `image:FILE.png` or
    /// `colours:FILE.svg`; empty: no painting.
    std::string patterns{};
    /// The patterns to choose from: a painting file, or ids with commas between; empty: the library's
    /// calibrated ones. With random:SEED an id may have a weight, `ID=3`; with colours:FILE.svg every id has
    /// its colour, `red=ID`.
    std::string palette{};
    std::string property{};  ///< of a pattern; for field and image
    std::string range{};     ///< of the property, SI: `0.02,0.1`
    bool dither = false;     ///< for field and image
    /// The prefix of these names in messages.
    std::string prefix = "--";
};

/// Throws InputError that names an entry that is malformed, or does not go with the patterns.
simulation::PaintingChoice read_painting(const PaintingText& text);

}  // namespace fretwork::typed
