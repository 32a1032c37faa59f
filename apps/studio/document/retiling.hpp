// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/simulation/project/retiling.hpp>
#include <studio/document/history.hpp>

#include <memory>
#include <optional>
#include <string>

namespace fretwork::studio {

/// Yes: the tiles are only shown, and the document does not change.
enum class Preview { No, Yes };

/// The request `retile`: other tiles for the outline of a document.
struct RetileRequest {
    simulation::RetilingOptions options;
    /// "keep": each tile takes the pattern of the nearest old tile, and recipes are followed again;
    /// "made:one": all tiles get one pattern that can be made; else the id of the pattern of all tiles.
    std::string patterns = "keep";
    Preview preview = Preview::No;
};
/// Throws InputError if the request is malformed, or asks to keep the patterns with another layout.
RetileRequest read_retile(const base::JsonReader& json, const State& state);

/// The result of the slow part of a request: the tiles and, with "made:one", the pattern that can be made on
/// them.
struct Retiling {
    StatePtr of;  ///< the document when it was asked for
    RetileRequest wanted;
    simulation::NewTiles tiles;
    std::optional<pattern::NamedPattern> pattern{};  ///< of all tiles; none: by place, or none can be made
    std::string remark{};                            ///< for people; empty: there is none
};
using RetilingPtr = std::shared_ptr<const Retiling>;
/// Throws InputError, GeometryError and Stopped.
Retiling make_retiling(const StatePtr& state, const RetileRequest& wanted, const base::Control& control);
/// True if a request gets the same tiles and the same pattern, whatever has been painted and loaded since.
bool gives_the_same(const Retiling& known, const State& state, const RetileRequest& wanted);

/// A document on other tiles, and the answer to its page.
struct Retiled {
    Edited edit;
    base::Json answer;
};
/// Put the tiles into a document whose ground is the one they were made for. With "keep", recipes are
/// followed again on the new tiles. Throws InputError if a load case finds no node, or a painting cannot be
/// made again.
/// @param preview  Yes: the answer has the polygons of the tiles
Retiled retiled(const State& state, const Retiling& made, Preview preview);

}  // namespace fretwork::studio
