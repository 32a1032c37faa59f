// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/outlines/coloured_drawing.hpp>
#include <fretwork/pattern/mirror.hpp>
#include <fretwork/simulation/detail/painting_palette.hpp>
#include <fretwork/simulation/project/painting_choice.hpp>
#include <fretwork/tiling/painting/field.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace fretwork::simulation {
namespace {

using tiling::Painting;
using tiling::Tessellation;
using tiling::TileIndex;

constexpr std::string_view kRandom = "random:";
constexpr std::string_view kField = "field:";
constexpr std::string_view kImage = "image:";
constexpr std::string_view kColours = "colours:";

std::uint64_t parse_seed(std::string_view text, const std::string& option) {
    if (const auto seed = base::read_number<std::uint64_t>(text)) return *seed;
    throw base::InputError(option, "", "'" + std::string(text) + "' is no seed; random:1 has one");
}

/// What follows a prefix, if it is there.
std::optional<std::string> after(const std::string& text, std::string_view prefix) {
    if (!text.starts_with(prefix)) return std::nullopt;
    return text.substr(prefix.size());
}

/// Along a palette, by an expression or an image.
bool is_by_field(const PaintingChoice& choice) {
    return after(choice.patterns, kField) || after(choice.patterns, kImage);
}

std::vector<TileIndex> all_tiles(const Tessellation& tessellation) {
    std::vector<TileIndex> tiles;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) tiles.emplace_back(t);
    return tiles;
}

/// A painting of all tiles, of which some are to be taken.
Painting part_of(const Painting& painting, std::span<const TileIndex> tiles, std::size_t count,
                 const std::string& file) {
    if (painting.tiles.size() != count)
        throw base::InputError(file, "/tiles",
                               "the painting is for " + std::to_string(painting.tiles.size()) +
                                   " tiles, and the tessellation has " + std::to_string(count));
    Painting part{painting.patterns, {}};
    for (const TileIndex tile : tiles) part.tiles.push_back(painting.tiles[static_cast<std::size_t>(tile)]);
    return part;
}

/// The place of a pattern in a list that has each once; added if it is new.
int place_in(std::vector<std::string>& patterns, const std::string& pattern) {
    const auto known = std::ranges::find(patterns, pattern);
    const auto place = static_cast<int>(known - patterns.begin());
    if (known == patterns.end()) patterns.push_back(pattern);
    return place;
}

/// One order to paint some tiles.
class Painter {
  public:
    Painter(const Tessellation& tessellation, std::span<const TileIndex> tiles, const PaintingChoice& choice,
            const PaintingGround& ground)
        : tessellation_(tessellation), tiles_(tiles.begin(), tiles.end()), choice_(choice), ground_(ground) {}

    Painting run() {
        const std::string& wanted = choice_.patterns;
        if (const auto seed = after(wanted, kRandom))
            return tiling::random_painting(tiles_.size(), detail::weighted_palette(choice_, ground_),
                                           parse_seed(*seed, choice_.names.patterns));
        if (is_by_field(choice_)) return by_field();
        if (const auto drawing = after(wanted, kColours)) return by_colours(*drawing);
        if (std::filesystem::path(wanted).extension() == ".json")
            return part_of(tiling::read_painting(wanted, ground_.layout), tiles_, tessellation_.tiles.size(),
                           wanted);
        return {detail::checked_palette(choice_.names.patterns, ground_.layout, {wanted}),
                std::vector<int>(tiles_.size(), 0)};
    }
    [[nodiscard]] const std::vector<TileIndex>& tiles() const { return tiles_; }

  private:
    [[nodiscard]] std::vector<geometry::Point2> places() const {
        const auto centers = tiling::tile_centers(tessellation_);
        std::vector<geometry::Point2> places;
        for (const TileIndex tile : tiles_) places.push_back(centers[static_cast<std::size_t>(tile)]);
        return places;
    }

    [[nodiscard]] std::vector<double> field_values() const {
        const auto box = tiling::bounding_box(tessellation_);
        if (const auto image = after(choice_.patterns, kImage))
            return tiling::image_values(*image, box, places());
        try {
            return tiling::expression_values(*after(choice_.patterns, kField), box, places());
        } catch (const base::InputError& error) {
            throw base::InputError(choice_.names.patterns, "", error.what());
        }
    }

    [[nodiscard]] Painting by_field() const {
        const auto palette = detail::graded_palette(choice_, ground_);
        const auto [low, high] = detail::wanted_range(choice_, palette);
        std::vector<double> wanted = field_values();
        for (double& value : wanted) value = low + value * (high - low);
        return tiling::graded_painting(tessellation_, tiles_, palette, wanted, choice_.dithering);
    }

    /// Tiles on other colours are left out.
    Painting by_colours(const std::string& file) {
        const outlines::ColouredDrawing drawing(file);
        const auto palette = detail::coloured_palette(choice_, ground_);
        check_colours(palette, drawing, file);
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
            painting.tiles.push_back(places_of_patterns[static_cast<std::size_t>(entry - palette.begin())]);
        }
        tiles_ = std::move(painted);
        return painting;
    }

    void check_colours(const std::vector<std::pair<std::string, std::string>>& palette,
                       const outlines::ColouredDrawing& drawing, const std::string& file) const {
        std::vector<std::string> there = drawing.colours();
        std::erase(there, "");
        for (const auto& [colour, pattern] : palette) {
            if (std::ranges::find(there, colour) != there.end()) continue;
            throw base::InputError(choice_.names.palette, "",
                                   "nothing in " + file + " is filled with " + colour + "; there is " +
                                       base::shortened(base::join(there, ", "), 200));
        }
    }

    const Tessellation& tessellation_;
    std::vector<TileIndex> tiles_;
    const PaintingChoice& choice_;
    const PaintingGround& ground_;
};

}  // namespace

void check(const PaintingChoice& choice) {
    const auto& names = choice.names;
    const auto refuse = [&](const std::string& option, const std::string& what) {
        throw base::InputError(option, "",
                               what + ", and " + names.patterns + " is " +
                                   (choice.patterns.empty() ? "not given" : "'" + choice.patterns + "'"));
    };
    const bool by_field = is_by_field(choice);
    const bool chooses = by_field || after(choice.patterns, kRandom) || after(choice.patterns, kColours);
    if (!choice.palette.empty() && !chooses)
        refuse(names.palette,
               "is what " + names.patterns + " random:SEED, field:, image: and colours: choose from");
    if (choice.palette.empty() && after(choice.patterns, kColours))
        refuse(names.palette, "has to say which pattern each colour stands for (red=ID,#00f=ID)");
    if (!choice.property.empty() && !by_field)
        refuse(names.property, "is for " + names.patterns + " field: and image:");
    if (!choice.range.empty() && choice.property.empty())
        throw base::InputError(names.range, "", "is a range of " + names.property + ", which is not given");
    if (choice.dithering != tiling::Dithering::None && !by_field)
        refuse(names.dithering, "is for " + names.patterns + " field: and image:");
}

void paint(Tessellation& tessellation, const PaintingChoice& choice, const PaintingGround& ground) {
    if (choice.patterns.empty()) return;
    const auto tiles = all_tiles(tessellation);
    Painter painter(tessellation, tiles, choice, ground);
    const Painting painting = painter.run();
    // Where every tile is painted anew, the palette stays as it was given: of many patterns only those in
    // use.
    if (painter.tiles().size() == tiles.size() && !is_by_field(choice))
        return tiling::paint(tessellation, painting);
    tiling::paint_tiles(tessellation, painter.tiles(), painting);
}

std::vector<TileIndex> paint(Tessellation& tessellation, std::span<const TileIndex> tiles,
                             const PaintingChoice& choice, const PaintingGround& ground) {
    Painter painter(tessellation, tiles, choice, ground);
    const Painting painting = painter.run();
    tiling::paint_tiles(tessellation, painter.tiles(), painting);
    return painter.tiles();
}

void mirror(Tessellation& tessellation, std::span<const TileIndex> tiles, const pattern::NodeLayout& layout) {
    const pattern::Mirror mirror(layout);
    Painting painting;
    for (const std::string& id : tessellation.patterns) {
        const auto image = mirror.image(pattern::parse_pattern_id(layout, id));
        painting.patterns.push_back(image ? pattern::pattern_id(layout, *image) : "");
    }
    for (const TileIndex tile : tiles) {
        const int now = tessellation.tiles[static_cast<std::size_t>(tile)].pattern;
        if (now < 0) throw base::InputError("tile " + std::to_string(tile) + " is not painted");
        if (painting.patterns[static_cast<std::size_t>(now)].empty())
            throw base::InputError("the layout '" + layout.name() + "' has no mirror image of " +
                                   tessellation.patterns[static_cast<std::size_t>(now)]);
        painting.tiles.push_back(now);
    }
    tiling::paint_tiles(tessellation, tiles, painting);
}

}  // namespace fretwork::simulation
