// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::tiling {

/// The patterns with these ids, in order, checked for use in a painting. Throws InputError if an id is not
/// valid. Throws InputError that names the pattern and the rule if a pattern crosses itself, misses an
/// interface node, is not connected, has a part that carries no force, or appears twice.
std::vector<pattern::NamedPattern> make_palette(const pattern::NodeLayout& layout,
                                                std::span<const std::string> ids);

/// Paint every tile with one of the patterns, uniformly at random. The same seed gives the same painting on
/// every machine. Throws InputError if there are no patterns.
void paint_randomly(Tessellation& tessellation, std::span<const pattern::NamedPattern> patterns,
                    std::uint64_t seed);

/// Paint every tile with the same pattern.
void paint_uniformly(Tessellation& tessellation, const pattern::NamedPattern& pattern);

/// The content of a painting file: a list of patterns, and the pattern of each tile. A file without tiles is
/// a palette.
struct Painting {
    std::vector<pattern::NamedPattern> patterns;  ///< the patterns in use
    std::vector<int> tiles;                       ///< for each tile, the index of its pattern in `patterns`
};

/// Parse a painting:
///
///     { "format": "fretwork/painting/1", "layout": "paper7",
///       "patterns": ["0-1+1-6", "0-5+5-6"], "tiles": [0, 0, 1, 0] }
///
/// `tiles` has one entry for each tile, in the order of the tiles, and may be left out. Throws InputError
/// with source and JSON pointer; the patterns are checked as by make_palette.
///
/// @param source  the name of the text in messages
Painting parse_painting(std::string_view text, const std::string& source, const pattern::NodeLayout& layout);
/// The painting as JSON; parse_painting gives an equal painting.
std::string painting_text(const Painting& painting, const pattern::NodeLayout& layout);
/// Read a painting file. Throws as parse_painting.
Painting read_painting(const std::filesystem::path& path, const pattern::NodeLayout& layout);
/// Write a painting file atomically. Throws IoError if this fails; the file is then as it was.
void write_painting(const Painting& painting, const pattern::NodeLayout& layout,
                    const std::filesystem::path& path);

/// Paint every tile according to the painting. Throws InputError if the numbers of tiles differ, or if the
/// painting has no pattern with an index that it uses.
void paint(Tessellation& tessellation, const Painting& painting);

/// A pattern with its weight in a random choice.
struct WeightedPattern {
    pattern::NamedPattern pattern;  ///< the pattern
    /// The weight, above 0; the probability is the weight over the sum of all weights.
    double weight = 1.0;
};

/// The largest number of tiles of a random painting, a hundred times that of a tessellation of an outline.
inline constexpr std::size_t kMostPaintedTiles = 10'000'000;

/// A random painting for `tiles` tiles. The same seed gives the same painting on every machine. Throws
/// InputError if there are no patterns, if a weight is not a finite number above zero, or if there are more
/// than kMostPaintedTiles tiles.
Painting random_painting(std::size_t tiles, std::span<const WeightedPattern> patterns, std::uint64_t seed);

/// Paint the listed tiles with the patterns of the painting: tile k of the list as entry k of its tiles. All
/// other tiles keep their patterns. Patterns that no tile has any more are removed from
/// Tessellation::patterns. Throws InputError if the numbers of tiles differ, or if the painting has no
/// pattern with an index that it uses.
void paint_tiles(Tessellation& tessellation, std::span<const TileIndex> tiles, const Painting& painting);

}  // namespace fretwork::tiling
