// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/json_reader.hpp>
#include <studio/document/state.hpp>

#include <string>
#include <typed/painting_text.hpp>
#include <vector>

namespace fretwork::studio {

/// Tiles of a document by their numbers: at least one.
std::vector<std::size_t> read_tiles(const base::JsonReader& json, const State& state);

/// The keys `patterns`, `palette`, `property`, `range` and `dither` of a request, as the options of
/// `fretwork paint`; each may be left out.
typed::PaintingText read_painting_text(const base::JsonReader& request);

/// The kind of a recipe's choice as requests call it: "field", "image", "colours" or "random".
std::string kind_of(const simulation::PaintingChoice& recipe);

/// The painting after all its recipes are followed again, each on the tiles that have it. Throws InputError
/// if one cannot be followed, such as because the library has changed.
Painting painted_again(const State& state);

/// The patterns of a tessellation with the document's tiles, as a painting of the document. Its palette keeps
/// its patterns, and the new ones follow.
Painting painted_as(const State& state, const tiling::Tessellation& painted);

/// A painting that a request makes of another one.
struct Painted {
    Painting painting;
    std::size_t tiles = 0;  ///< that were painted
    std::vector<std::string> remarks{};
};
/// The painting that `paint` asks for. Throws InputError if it is malformed, or cannot be painted.
Painted painted(const State& state, const base::JsonReader& request);

}  // namespace fretwork::studio
