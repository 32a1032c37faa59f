// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/base/random.hpp>
#include <fretwork/pattern/filter_catalogue.hpp>
#include <fretwork/pattern/pattern.hpp>
#include <fretwork/tiling/painting/painting.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace fretwork::tiling {
namespace {

using pattern::NamedPattern;

/// The filters that every pattern must pass. The paper's other two filters have numbers, which are a matter
/// of choice.
std::vector<pattern::Filter> structural_filters(const pattern::NodeLayout& layout) {
    std::vector<pattern::Filter> filters;
    for (const pattern::FilterKind& kind : pattern::filter_catalogue()) {
        if (!kind.is_of_the_paper || kind.parameter != pattern::FilterParameter::None) continue;
        filters.push_back({std::string(kind.name), kind.default_value,
                           kind.make_rule(layout, kind.default_value, pattern::FabricationScale{})});
    }
    return filters;
}

/// A palette to which patterns are added one by one.
class Palette {
  public:
    explicit Palette(const pattern::NodeLayout& layout)
        : layout_(layout), filters_(structural_filters(layout)) {}

    /// Check a pattern and add it. Throws InputError that names the pattern and the rule that it breaks.
    void add(std::string_view text) {
        pattern::NamedPattern pattern = pattern::parse_named_pattern(layout_, text);
        const pattern::Verdict verdict = pattern::judge(layout_, filters_, pattern.pattern);
        if (!verdict.accepted)
            throw base::InputError("'" + pattern.id + "' is not a valid pattern (" + verdict.filter +
                                   "): " + verdict.reason);
        if (std::ranges::find(patterns_, pattern) != patterns_.end())
            throw base::InputError("the pattern " + pattern.id + " is named twice");
        patterns_.push_back(std::move(pattern));
    }
    [[nodiscard]] const std::vector<NamedPattern>& patterns() const { return patterns_; }

  private:
    const pattern::NodeLayout& layout_;
    std::vector<pattern::Filter> filters_;
    std::vector<NamedPattern> patterns_;
};

std::vector<NamedPattern> read_patterns(const base::JsonReader& list, const pattern::NodeLayout& layout) {
    Palette palette(layout);
    for (const base::JsonReader& element : list.elements()) {
        const std::string id = element.string();
        element.located([&] { palette.add(id); });
    }
    if (palette.patterns().empty()) list.fail("is empty, where at least one pattern is needed");
    return palette.patterns();
}

void check_indices(const Painting& painting) {
    for (const int pattern : painting.tiles) {
        if (pattern < 0 || pattern >= static_cast<int>(painting.patterns.size()))
            throw base::InputError("the painting has no pattern " + std::to_string(pattern));
    }
}

}  // namespace

std::vector<NamedPattern> make_palette(const pattern::NodeLayout& layout, std::span<const std::string> ids) {
    Palette palette(layout);
    for (const std::string& id : ids) palette.add(id);
    return palette.patterns();
}

void paint_randomly(Tessellation& tessellation, std::span<const NamedPattern> patterns, std::uint64_t seed) {
    if (patterns.empty()) throw base::InputError("there is no pattern to paint with");
    tessellation.patterns.assign(patterns.begin(), patterns.end());
    base::SplitMix64 random(seed);
    for (Tile& tile : tessellation.tiles) tile.pattern = static_cast<int>(random.below(patterns.size()));
}

void paint_uniformly(Tessellation& tessellation, const NamedPattern& pattern) {
    tessellation.patterns = {pattern};
    for (Tile& tile : tessellation.tiles) tile.pattern = 0;
}

Painting parse_painting(std::string_view text, const std::string& source, const pattern::NodeLayout& layout) {
    const auto file = base::JsonReader::from_text(text, source);
    file.expect_format("painting");
    file.allow_only({"format", "layout", "patterns", "tiles"});
    if (const auto name = file.at("layout"); name.string() != layout.name())
        name.fail("is " + name.text() + ", where the layout in use is \"" + layout.name() + "\"");
    Painting painting;
    painting.patterns = read_patterns(file.at("patterns"), layout);
    if (const auto tiles = file.find("tiles")) {
        const auto last = static_cast<long long>(painting.patterns.size()) - 1;
        for (const base::JsonReader& tile : tiles->elements())
            painting.tiles.push_back(static_cast<int>(tile.integer(0, last)));
        if (painting.tiles.empty()) tiles->fail("is empty; leave it out to give a palette");
    }
    return painting;
}

std::string painting_text(const Painting& painting, const pattern::NodeLayout& layout) {
    base::Json json;
    json["format"] = "fretwork/painting/1";
    json["layout"] = layout.name();
    json["patterns"] = pattern::ids_of(painting.patterns);
    if (!painting.tiles.empty()) json["tiles"] = painting.tiles;
    return base::json_text(json);
}

Painting read_painting(const std::filesystem::path& path, const pattern::NodeLayout& layout) {
    return parse_painting(base::read_text_file(path), path.string(), layout);
}

void write_painting(const Painting& painting, const pattern::NodeLayout& layout,
                    const std::filesystem::path& path) {
    base::write_file_atomically(path, painting_text(painting, layout));
}

void paint(Tessellation& tessellation, const Painting& painting) {
    if (painting.tiles.size() != tessellation.tiles.size())
        throw base::InputError("the painting is for " + std::to_string(painting.tiles.size()) +
                               " tiles, and the tessellation has " +
                               std::to_string(tessellation.tiles.size()));
    check_indices(painting);
    tessellation.patterns = painting.patterns;
    for (std::size_t t = 0; t < painting.tiles.size(); ++t) tessellation.tiles[t].pattern = painting.tiles[t];
}

Painting random_painting(std::size_t tiles, std::span<const WeightedPattern> patterns, std::uint64_t seed) {
    if (patterns.empty()) throw base::InputError("there is no pattern to paint with");
    if (tiles > kMostPaintedTiles)
        throw base::InputError("the number of tiles is " + std::to_string(tiles) + ", where 0 to " +
                               std::to_string(kMostPaintedTiles) + " are possible");
    Painting painting;
    std::vector<double> shares;  // sum of the weights up to and including each pattern
    for (const WeightedPattern& choice : patterns) {
        if (!(choice.weight > 0.0) || !std::isfinite(choice.weight))
            throw base::InputError("the weight of " + choice.pattern.id +
                                   " is not a finite number above zero");
        painting.patterns.push_back(choice.pattern);
        shares.push_back((shares.empty() ? 0.0 : shares.back()) + choice.weight);
    }
    const bool is_even = std::ranges::all_of(
        patterns, [&](const WeightedPattern& choice) { return choice.weight == patterns.front().weight; });
    base::SplitMix64 random(seed);
    for (std::size_t t = 0; t < tiles; ++t) {
        // Equal weights use the random numbers as paint_randomly() does, so the same seed gives the same
        // painting.
        const auto place =
            is_even ? static_cast<std::ptrdiff_t>(random.below(patterns.size()))
                    : std::ranges::upper_bound(shares, random.share() * shares.back()) - shares.begin();
        painting.tiles.push_back(static_cast<int>(std::min(place, std::ssize(patterns) - 1)));
    }
    return painting;
}

void paint_tiles(Tessellation& tessellation, std::span<const TileIndex> tiles, const Painting& painting) {
    if (painting.tiles.size() != tiles.size())
        throw base::InputError("the painting is for " + std::to_string(painting.tiles.size()) +
                               " tiles, and " + std::to_string(tiles.size()) + " are to be painted");
    check_indices(painting);
    const std::size_t before = tessellation.patterns.size();
    std::vector<NamedPattern> all = tessellation.patterns;
    std::ranges::copy(painting.patterns, std::back_inserter(all));
    for (std::size_t i = 0; i < tiles.size(); ++i)
        tessellation.tiles[tiles[i]].pattern = static_cast<int>(before) + painting.tiles[i];
    // The used patterns, each once, in the order of the palettes.
    std::vector<int> place(all.size(), -1);
    std::set<int> used;
    for (const Tile& tile : tessellation.tiles) used.insert(tile.pattern);
    std::vector<NamedPattern> kept;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!used.contains(static_cast<int>(i))) continue;
        const auto known = std::ranges::find(kept, all[i]);
        place[i] = static_cast<int>(known - kept.begin());
        if (known == kept.end()) kept.push_back(all[i]);
    }
    for (Tile& tile : tessellation.tiles)
        if (tile.pattern >= 0) tile.pattern = place[tile.pattern];
    tessellation.patterns = std::move(kept);
}

}  // namespace fretwork::tiling
