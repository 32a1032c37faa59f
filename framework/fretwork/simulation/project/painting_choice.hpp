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

/// The patterns that a painting chooses from: those that are named, or those of a painting file, or the
/// calibrated ones of the library.
struct PaletteChoice {
    std::vector<std::string> ids{};
    std::filesystem::path file{};  ///< a painting file; taken where no ids are given
};

/// All tiles have one pattern.
struct PaintOnePattern {
    std::string id;
};

/// As a painting file says.
struct PaintFromFile {
    std::filesystem::path file;
};

/// By chance.
struct PaintAtRandom {
    std::uint64_t seed = 1;
    PaletteChoice palette{};
    std::vector<double> weights{};  ///< of the palette's ids, above zero; empty: all are equally likely
};

/// A number over the surface: an expression of x and y (m), and of u and v (0 to 1 across the surface).
struct FieldExpression {
    std::string text;
};
/// A number over the surface: how dark a PNG image is that is stretched over it (white 0, black 1).
struct FieldImage {
    std::filesystem::path file;
};

/// Along a palette, by a field that goes from 0 to 1.
struct PaintByField {
    std::variant<FieldExpression, FieldImage> field;
    PaletteChoice palette{};
    /// The property of patterns (`bending_stiffness`) whose values decide; empty: the palette's order does.
    std::string property{};
    /// The property's values, SI, where the field is 0 and 1; none: the palette's least and largest.
    std::optional<std::pair<double, double>> range{};
    tiling::Dithering dithering = tiling::Dithering::None;
};

/// By the colour that a drawing has where a tile lies. Tiles on other colours keep their patterns.
struct PaintByColours {
    std::filesystem::path drawing;                             ///< SVG
    std::vector<std::pair<std::string, std::string>> palette;  ///< colours "#rrggbb", each with an id
};

/// How tiles are painted; monostate: not at all.
using PaintingChoice =
    std::variant<std::monostate, PaintOnePattern, PaintFromFile, PaintAtRandom, PaintByField, PaintByColours>;

/// The layout, setting and library that pattern ids refer to. `library` may be null.
struct PaintingGround {
    base::Borrowed<pattern::NodeLayout> layout;
    base::Borrowed<reduction::Setting> setting;
    const library::Library* library = nullptr;
};

/// Paint all tiles as it is chosen. Throws InputError whose source is a file, or what is wrong of the choice:
/// "patterns", "palette", "property", "range" or "library".
void paint(tiling::Tessellation& tessellation, const PaintingChoice& choice, const PaintingGround& ground);
/// The same for some tiles; the others keep theirs. Random paintings and fields paint the tiles in this
/// order. A painting file gives each tile the pattern that it has for that tile. With colours, tiles on none
/// of the palette's colours keep theirs. Returns the tiles that were painted.
std::vector<tiling::TileIndex> paint(tiling::Tessellation& tessellation,
                                     std::span<const tiling::TileIndex> tiles, const PaintingChoice& choice,
                                     const PaintingGround& ground);

/// Replace the patterns of some tiles by their mirror images. Throws InputError that names a pattern whose
/// mirror image the layout does not have, or a tile that is not painted.
void mirror(tiling::Tessellation& tessellation, std::span<const tiling::TileIndex> tiles,
            const pattern::NodeLayout& layout);

}  // namespace fretwork::simulation
