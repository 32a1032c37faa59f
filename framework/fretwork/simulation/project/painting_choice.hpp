// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/borrowed.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/pattern/node_layout.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>
#include <fretwork/tiling/painting/graded_painting.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace fretwork::simulation {

/// The palette of a painting: listed patterns; if none are listed, the patterns of a painting file; without a
/// file, the calibrated patterns of the library.
struct PaletteChoice {
    std::vector<std::string> ids{};  ///< ids of patterns
    std::filesystem::path file{};    ///< painting file, used if `ids` is empty
    friend bool operator==(const PaletteChoice&, const PaletteChoice&) = default;
};

/// Paint all tiles with one pattern.
struct PaintOnePattern {
    std::string id;  ///< id of the pattern
    friend bool operator==(const PaintOnePattern&, const PaintOnePattern&) = default;
};

/// Paint as in a painting file.
struct PaintFromFile {
    std::filesystem::path file;  ///< painting file
    friend bool operator==(const PaintFromFile&, const PaintFromFile&) = default;
};

/// Paint at random.
struct PaintAtRandom {
    std::uint64_t seed = 1;   ///< seed of the random choice
    PaletteChoice palette{};  ///< the palette
    /// Weights of the palette's patterns, above zero; empty: all patterns are equally likely.
    std::vector<double> weights{};
    friend bool operator==(const PaintAtRandom&, const PaintAtRandom&) = default;
};

/// A field over the surface: an expression of x and y (m), and of u and v (0 to 1 across the surface).
struct FieldExpression {
    std::string text;  ///< expression, such as `u` or `sin(30*x)^2`
    friend bool operator==(const FieldExpression&, const FieldExpression&) = default;
};

/// The bytes of a file, for choices that do not read it.
struct FileContent {
    std::string bytes;  ///< content of the file
    friend bool operator==(const FileContent&, const FileContent&) = default;
};
/// A field over the surface: the darkness of a PNG image, stretched over the surface (white 0, black 1).
struct FieldImage {
    std::filesystem::path file;            ///< PNG file; with a content, its name in messages
    std::optional<FileContent> content{};  ///< content of the file; none: it is read from `file`
    friend bool operator==(const FieldImage&, const FieldImage&) = default;
};

/// Paint by a field with values from 0 to 1. The values select patterns along a palette.
struct PaintByField {
    std::variant<FieldExpression, FieldImage> field;  ///< the field
    PaletteChoice palette{};                          ///< the palette
    /// The property that orders the patterns of the palette, such as `bending_stiffness`; empty: the
    /// palette's own order.
    std::string property{};
    /// The values of the property, SI, for the field values 0 and 1. None: the smallest and the largest value
    /// of the palette.
    std::optional<std::pair<double, double>> range{};
    tiling::Dithering dithering = tiling::Dithering::None;  ///< whether tiles pass their errors to neighbours
    friend bool operator==(const PaintByField&, const PaintByField&) = default;
};

/// Paint each tile by the colour of a drawing at the tile's place. Tiles on a colour that is not in `palette`
/// keep their patterns.
struct PaintByColours {
    std::filesystem::path drawing;  ///< SVG file; with a content, its name in messages
    /// Pairs of a colour "#rrggbb" and a pattern id; each colour once.
    std::vector<std::pair<std::string, std::string>> palette;
    std::optional<FileContent> content{};  ///< content of the drawing; none: it is read from `drawing`
    friend bool operator==(const PaintByColours&, const PaintByColours&) = default;
};

/// A way to paint tiles; monostate: they are not painted.
using PaintingChoice =
    std::variant<std::monostate, PaintOnePattern, PaintFromFile, PaintAtRandom, PaintByField, PaintByColours>;

/// A choice that gives patterns by place or by chance, and the tiles that it has painted. A project keeps it
/// to paint the tiles that replace these, such as after a retiling (painting_recipe.hpp). It needs no file:
/// palettes list ids, and images and drawings come with their content.
struct PaintingRecipe {
    PaintingChoice choice;                 ///< by a field, by colours, or at random
    std::vector<tiling::TileIndex> tiles;  ///< its tiles, ascending
    friend bool operator==(const PaintingRecipe&, const PaintingRecipe&) = default;
};

/// The layout of pattern ids, and the setting and the library behind their properties.
struct PaintingGround {
    base::Borrowed<pattern::NodeLayout> layout;  ///< node layout of the patterns
    base::Borrowed<reduction::Setting> setting;  ///< setting for properties that the library lacks
    /// Library with properties, and with the patterns of a palette that names none; may be null.
    const library::Library* library = nullptr;
};

/// Paint all tiles by a choice. Returns the painted tiles: all; with colours, those on a colour of the
/// palette; with monostate, none. Throws InputError that names a file, an invalid entry of the choice
/// ("patterns", "palette", "property" or "library"), or a pattern whose weight is not above zero; and as
/// reduction::effective_properties().
std::vector<tiling::TileIndex> paint(tiling::Tessellation& tessellation, const PaintingChoice& choice,
                                     const PaintingGround& ground);
/// Paint some tiles by a choice; other tiles keep their patterns. Random paintings and fields paint the tiles
/// in the order of `tiles`. With a painting file, each tile takes the pattern that the file gives this tile.
/// With colours, tiles on a colour that is not in the palette keep their patterns. Returns the painted tiles.
/// Throws as above. Pre: the tiles exist.
std::vector<tiling::TileIndex> paint(tiling::Tessellation& tessellation,
                                     std::span<const tiling::TileIndex> tiles, const PaintingChoice& choice,
                                     const PaintingGround& ground);

/// Replace the patterns of the listed tiles by their mirror images. Throws InputError that names a pattern
/// without a mirror image in the layout, or a tile that is not painted. Pre: the tiles exist.
void mirror(tiling::Tessellation& tessellation, std::span<const tiling::TileIndex> tiles,
            const pattern::NodeLayout& layout);

}  // namespace fretwork::simulation
