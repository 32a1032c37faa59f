// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/project/painting_choice.hpp>

#include <string>

namespace fretwork::typed {

/// The choice of a painting, as a person writes it.
struct PaintingText {
    /// One pattern's id, a painting file, `random:SEED`, `field:EXPRESSION`, `image:FILE.png` or
    /// `colours:FILE.svg`; empty: no painting.
    std::string patterns{};
    /// The patterns to choose from: a painting file, or ids joined by commas; empty: the calibrated patterns
    /// of the library. With random:SEED, an id may have a weight, `ID=3`. With colours:FILE.svg, only ids are
    /// valid, at least one, and every id needs a colour of its own, `red=ID` or `rgb(255, 0, 0)=ID`.
    std::string palette{};
    std::string property{};  ///< property of patterns, for field and image
    std::string range{};     ///< range of the property, SI: `0.02,0.1`
    bool dither = false;     ///< true: error diffusion, for field and image
    /// The prefix of these names in messages.
    std::string prefix = "--";
};

/// Read the choice. Throws InputError that names an entry if this entry is malformed or does not fit the
/// other entries.
simulation::PaintingChoice read_painting(const PaintingText& text);

}  // namespace fretwork::typed
