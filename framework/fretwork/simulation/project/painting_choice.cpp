// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/outlines/coloured_drawing.hpp>
#include <fretwork/pattern/mirror.hpp>
#include <fretwork/simulation/detail/painting_palette.hpp>
#include <fretwork/simulation/project/painting_choice.hpp>
#include <fretwork/tiling/painting/field.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <algorithm>

namespace fretwork::simulation {
namespace {

using pattern::NamedPattern;
using tiling::Painting;
using tiling::Tessellation;
using tiling::TileIndex;

std::vector<TileIndex> all_tiles(const Tessellation& tessellation) {
    std::vector<TileIndex> tiles;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) tiles.emplace_back(t);
    return tiles;
}

/// The part of a painting of all tiles that is for `tiles`.
Painting part_of(const Painting& painting, std::span<const TileIndex> tiles, std::size_t count,
                 const std::string& file) {
    if (painting.tiles.size() != count)
        throw base::InputError(file, "/tiles",
                               "the painting is for " + std::to_string(painting.tiles.size()) +
                                   " tiles, and the tessellation has " + std::to_string(count));
    Painting part{painting.patterns, {}};
    for (const TileIndex tile : tiles) part.tiles.push_back(painting.tiles[tile]);
    return part;
}

/// The place of a pattern in a list without repetitions. A new pattern is added.
int place_in(std::vector<NamedPattern>& patterns, const NamedPattern& pattern) {
    const auto known = std::ranges::find(patterns, pattern);
    const auto place = static_cast<int>(known - patterns.begin());
    if (known == patterns.end()) patterns.push_back(pattern);
    return place;
}

/// Makes the painting of some tiles, with one operator for each kind of choice.
class Painter {
  public:
    Painter(const Tessellation& tessellation, std::span<const TileIndex> tiles, const PaintingGround& ground)
        : tessellation_(tessellation), tiles_(tiles.begin(), tiles.end()), ground_(ground) {}

    Painting operator()(std::monostate) {
        tiles_.clear();
        return {};
    }
    Painting operator()(const PaintOnePattern& choice) const {
        return {detail::checked_palette("patterns", ground_.layout, {choice.id}),
                std::vector<int>(tiles_.size(), 0)};
    }
    Painting operator()(const PaintFromFile& choice) const {
        return part_of(tiling::read_painting(choice.file, ground_.layout), tiles_, tessellation_.tiles.size(),
                       choice.file.string());
    }
    Painting operator()(const PaintAtRandom& choice) const {
        return tiling::random_painting(tiles_.size(), detail::weighted_palette(choice, ground_), choice.seed);
    }
    Painting operator()(const PaintByField& choice) const {
        const auto palette = detail::graded_palette(choice, ground_);
        const auto [low, high] = detail::wanted_range(choice, palette);
        std::vector<double> wanted =
            std::visit([this](const auto& field) { return values_of(field); }, choice.field);
        for (double& value : wanted) value = low + value * (high - low);
        return tiling::graded_painting(tessellation_, tiles_, palette, wanted, choice.dithering);
    }
    /// Tiles on other colours are left out.
    Painting operator()(const PaintByColours& choice) {
        const std::string name = choice.drawing.string();
        const outlines::ColouredDrawing drawing =
            choice.content ? outlines::ColouredDrawing::parse(choice.content->bytes, name)
                           : outlines::ColouredDrawing(choice.drawing);
        const auto palette = detail::coloured_palette(choice, ground_);
        check_colours(palette, drawing, name);
        const auto seen_at = places();
        Painting painting;
        std::vector<int> places_of_patterns;  // several colours may stand for one pattern
        for (const auto& [colour, pattern] : palette)
            places_of_patterns.push_back(place_in(painting.patterns, pattern));
        std::vector<TileIndex> painted;
        for (std::size_t i = 0; i < tiles_.size(); ++i) {
            const auto colour = drawing.colour_at(seen_at[i]);
            const auto entry = std::ranges::find_if(
                palette, [&](const auto& known) { return colour && known.first == *colour; });
            if (entry == palette.end()) continue;
            painted.push_back(tiles_[i]);
            painting.tiles.push_back(places_of_patterns[entry - palette.begin()]);
        }
        tiles_ = std::move(painted);
        return painting;
    }
    /// The painted tiles.
    [[nodiscard]] const std::vector<TileIndex>& tiles() const { return tiles_; }

  private:
    [[nodiscard]] std::vector<geometry::Point2> places() const {
        const auto centers = tiling::tile_centers(tessellation_);
        std::vector<geometry::Point2> places;
        for (const TileIndex tile : tiles_) places.push_back(centers[tile]);
        return places;
    }

    [[nodiscard]] std::vector<double> values_of(const FieldImage& image) const {
        const geometry::Box box = tiling::bounding_box(tessellation_);
        if (!image.content) return tiling::image_values(image.file, box, places());
        return tiling::image_values(image.content->bytes, image.file.string(), box, places());
    }
    [[nodiscard]] std::vector<double> values_of(const FieldExpression& expression) const {
        return base::located("patterns", "", [&] {
            return tiling::expression_values(expression.text, tiling::bounding_box(tessellation_), places());
        });
    }

    static void check_colours(const std::vector<std::pair<std::string, NamedPattern>>& palette,
                              const outlines::ColouredDrawing& drawing, const std::string& file) {
        std::vector<std::string> there = drawing.colours();
        std::erase(there, "");
        for (const auto& [colour, pattern] : palette) {
            if (std::ranges::find(there, colour) != there.end()) continue;
            throw base::InputError(file, "",
                                   "nothing in it is filled with " + colour + "; there is " +
                                       base::shortened(base::join(there, ", "), 200));
        }
    }

    const Tessellation& tessellation_;
    std::vector<TileIndex> tiles_;
    const PaintingGround& ground_;
};

}  // namespace

std::vector<TileIndex> paint(Tessellation& tessellation, const PaintingChoice& choice,
                             const PaintingGround& ground) {
    if (std::holds_alternative<std::monostate>(choice)) return {};
    const auto tiles = all_tiles(tessellation);
    Painter painter(tessellation, tiles, ground);
    const Painting painting = std::visit(painter, choice);
    // If every tile is painted again, but not by a field, the given palette replaces the old one,
    // in the given order and with its unused patterns.
    if (painter.tiles().size() == tiles.size() && !std::holds_alternative<PaintByField>(choice))
        tiling::paint(tessellation, painting);
    else
        tiling::paint_tiles(tessellation, painter.tiles(), painting);
    return painter.tiles();
}

std::vector<TileIndex> paint(Tessellation& tessellation, std::span<const TileIndex> tiles,
                             const PaintingChoice& choice, const PaintingGround& ground) {
    Painter painter(tessellation, tiles, ground);
    const Painting painting = std::visit(painter, choice);
    tiling::paint_tiles(tessellation, painter.tiles(), painting);
    return painter.tiles();
}

void mirror(Tessellation& tessellation, std::span<const TileIndex> tiles, const pattern::NodeLayout& layout) {
    const pattern::Mirror mirror(layout);
    Painting painting;
    for (const NamedPattern& own : tessellation.patterns) {
        const auto image = mirror.image(own.pattern);
        painting.patterns.push_back(image ? pattern::named(layout, *image) : NamedPattern{});
    }
    for (const TileIndex tile : tiles) {
        const int now = tessellation.tiles[tile].pattern;
        if (now < 0) throw base::InputError("tile " + std::to_string(tile) + " is not painted");
        if (painting.patterns[now].id.empty())
            throw base::InputError("the layout '" + layout.name() + "' has no mirror image of " +
                                   tessellation.patterns[now].id);
        painting.tiles.push_back(now);
    }
    tiling::paint_tiles(tessellation, tiles, painting);
}

}  // namespace fretwork::simulation
