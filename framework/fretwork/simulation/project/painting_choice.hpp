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

/// The patterns that a painting chooses from: the listed ones, or those of a painting file, or the calibrated
/// patterns of the library.
struct PaletteChoice {
    std::vector<std::string> ids{};  ///< of patterns
    std::filesystem::path file{};    ///< a painting file, used if `ids` is empty
};

/// Paint all tiles with one pattern.
struct PaintOnePattern {
    std::string id;  ///< of the pattern
};

/// Paint as in a painting file.
struct PaintFromFile {
    std::filesystem::path file;  ///< a painting file
};

/// Paint at random.
struct PaintAtRandom {
    std::uint64_t seed = 1;         ///< of the choice
    PaletteChoice palette{};        ///< what is chosen from
    std::vector<double> weights{};  ///< weights of the palette's ids, above zero; empty: all are equally
                                    ///< likely
};

/// A field over the surface: an expression of x and y (m), and of u and v (0 to 1 across the surface).
struct FieldExpression {
    std::string text;  ///< such as `u` or `sin(30*x)^2`
};
/// A field over the surface: the darkness of a PNG image stretched over it (white 0, black 1).
struct FieldImage {
    std::filesystem::path file;  ///< a PNG image
};

/// Paint by a field with values from 0 to 1, which selects patterns along a palette.
struct PaintByField {
    std::variant<FieldExpression, FieldImage> field;  ///< the number over the surface
    PaletteChoice palette{};                          ///< what is chosen from
    /// The property of patterns (`bending_stiffness`) that orders the palette; empty: the palette's own order
    /// counts.
    std::string property{};
    /// The property's values, SI, for field values 0 and 1. None: the palette's smallest and largest.
    std::optional<std::pair<double, double>> range{};
    tiling::Dithering dithering = tiling::Dithering::None;  ///< whether patterns are mixed
};

/// Paint each tile by the colour of a drawing at the tile's place. Tiles on other colours keep their
/// patterns.
struct PaintByColours {
    std::filesystem::path drawing;                             ///< SVG
    std::vector<std::pair<std::string, std::string>> palette;  ///< pairs of a colour "#rrggbb" and a pattern
                                                               ///< id
};

/// The way in which tiles are painted; monostate: they are not painted.
using PaintingChoice =
    std::variant<std::monostate, PaintOnePattern, PaintFromFile, PaintAtRandom, PaintByField, PaintByColours>;

/// The layout, setting and library that pattern ids refer to. `library` may be null.
struct PaintingGround {
    base::Borrowed<pattern::NodeLayout> layout;  ///< of the patterns
    base::Borrowed<reduction::Setting> setting;  ///< for properties that are computed
    const library::Library* library = nullptr;   ///< for properties that are known; may be null
};

/// Paint all tiles by a choice. Throws InputError whose source is a file, or the invalid entry of the choice:
/// "patterns", "palette", "property", "range" or "library".
void paint(tiling::Tessellation& tessellation, const PaintingChoice& choice, const PaintingGround& ground);
/// Paint some tiles by a choice; other tiles keep their patterns. Random paintings and fields paint the tiles
/// in the order of `tiles`. From a painting file, each tile takes its own pattern. With colours, tiles on
/// other colours than the palette's keep their patterns. Returns the painted tiles.
std::vector<tiling::TileIndex> paint(tiling::Tessellation& tessellation,
                                     std::span<const tiling::TileIndex> tiles, const PaintingChoice& choice,
                                     const PaintingGround& ground);

/// Replace the patterns of some tiles by their mirror images. Throws InputError that names a pattern whose
/// mirror image the layout does not have, or a tile that is not painted.
void mirror(tiling::Tessellation& tessellation, std::span<const tiling::TileIndex> tiles,
            const pattern::NodeLayout& layout);

}  // namespace fretwork::simulation
