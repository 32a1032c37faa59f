// SPDX-License-Identifier: GPL-3.0-or-later
// A page's request to paint.
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/project/painting_recipe.hpp>
#include <fretwork/tiling/painting/painting.hpp>
#include <studio/document/painting_request.hpp>
#include <studio/server/sent_file.hpp>
#include <studio/solving/synced_session.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace fretwork::studio {
namespace {

using base::JsonReader;
using tiling::TileIndex;
using typed::PaintingText;

/// The places of patterns in a palette, which grows by those that are new.
class PaletteWriter {
  public:
    PaletteWriter(Painting& painting, const pattern::NodeLayout& layout)
        : painting_(painting), layout_(layout) {}

    int place_of(const JsonReader& json) {
        const std::string text = json.string();
        const auto [known, is_new] = places_.try_emplace(text, 0);
        if (is_new) known->second = place_of(checked(json, text));
        return known->second;
    }
    int place_of(const pattern::NamedPattern& pattern) {
        const auto found = std::ranges::find(painting_.palette, pattern);
        const auto place = found - painting_.palette.begin();
        if (found == painting_.palette.end()) painting_.palette.push_back(pattern);
        return static_cast<int>(place);
    }

  private:
    [[nodiscard]] pattern::NamedPattern checked(const JsonReader& json, const std::string& text) const {
        return json.located([&] { return tiling::make_palette(layout_, std::vector{text}).front(); });
    }

    Painting& painting_;
    const pattern::NodeLayout& layout_;
    std::map<std::string, int> places_;
};

void paint_by_hand(Painting& painting, std::size_t tile, int place) {
    painting.patterns[tile] = place;
    painting.recipes[tile] = nullptr;
}

Painted with_one_pattern(const State& state, const JsonReader& request) {
    request.allow_only({"id", "do", "merge", "tiles", "pattern"});
    Painted result{*state.painting};
    const auto tiles = read_tiles(request.at("tiles"), state);
    const int place = PaletteWriter(result.painting, state.ground->layout).place_of(request.at("pattern"));
    for (const std::size_t tile : tiles) paint_by_hand(result.painting, tile, place);
    result.tiles = tiles.size();
    return result;
}

Painted tile_by_tile(const State& state, const JsonReader& request) {
    request.allow_only({"id", "do", "merge", "patterns"});
    Painted result{*state.painting};
    PaletteWriter palette(result.painting, state.ground->layout);
    const auto ids = request.at("patterns").elements(state.tile_count());
    for (std::size_t t = 0; t < ids.size(); ++t) {
        const int place = palette.place_of(ids[t]);
        if (place == result.painting.patterns[t]) continue;
        ++result.tiles;
        paint_by_hand(result.painting, t, place);
    }
    return result;
}

/// The named tiles, each once, or all if none are named. They are in ascending order, as the command takes
/// them: random choices depend on the order.
std::vector<TileIndex> chosen_tiles(const State& state, const JsonReader& request) {
    std::vector<std::size_t> numbers(state.tile_count());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    if (const auto named = request.find("tiles")) numbers = read_tiles(*named, state);
    std::ranges::sort(numbers);
    const auto repeated = std::ranges::unique(numbers);
    numbers.erase(repeated.begin(), repeated.end());
    return {numbers.begin(), numbers.end()};
}

using simulation::PaintingChoice;

/// True if the patterns or their properties are in a library.
bool looks_up(const PaintingChoice& choice) {
    const auto is_open = [](const simulation::PaletteChoice& palette) {
        return palette.ids.empty() && palette.file.empty();
    };
    if (const auto* random = std::get_if<simulation::PaintAtRandom>(&choice)) return is_open(random->palette);
    const auto* field = std::get_if<simulation::PaintByField>(&choice);
    return field != nullptr && (is_open(field->palette) || !field->property.empty());
}

/// The library, only if something is looked up in it: to check it for changes takes long if it is large.
std::optional<library::Library> library_for(const PaintingChoice& choice, const State& state) {
    if (!looks_up(choice)) return std::nullopt;
    auto library = open_library(state);
    if (library) library->check_layout(state.ground->layout);
    return library;
}

/// The recipe of a tile that equals the wanted one, else a new one: to paint the same again changes nothing.
std::shared_ptr<const PaintingChoice> known_or_new(const Painting& painting, const PaintingChoice& wanted) {
    std::set<const PaintingChoice*> seen;  // many tiles share one recipe, which may hold an image
    for (const auto& recipe : painting.recipes) {
        if (recipe && seen.insert(recipe.get()).second && *recipe == wanted) return recipe;
    }
    return std::make_shared<const PaintingChoice>(wanted);
}

Painted by_choice(const State& state, const std::vector<TileIndex>& tiles, const PaintingChoice& choice) {
    const auto library = library_for(choice, state);
    const simulation::PaintingGround ground{state.ground->layout, *state.setting,
                                            library ? &*library : nullptr};
    tiling::Tessellation tessellation = make_project(state, "/").tessellation;
    const auto done = simulation::paint(tessellation, tiles, choice, ground);
    const auto recipe = simulation::recipe_of(choice, ground);
    const auto kept = recipe ? known_or_new(*state.painting, *recipe) : nullptr;
    Painted result{*state.painting, done.size()};
    if (!recipe && !done.empty())
        if (const auto remark = simulation::unkept_file_remark(choice)) result.remarks.push_back(*remark);
    PaletteWriter palette(result.painting, state.ground->layout);
    for (const TileIndex tile : done) {
        result.painting.patterns[tile] = palette.place_of(*tiling::pattern_of(tessellation, tile));
        result.painting.recipes[tile] = kept;
    }
    return result;
}

/// The choice with the file that came with the request, in place of a path.
PaintingChoice with_file(PaintingChoice choice, const SentFile& sent) {
    const simulation::FileContent content{sent.content};
    if (auto* field = std::get_if<simulation::PaintByField>(&choice))
        field->field = simulation::FieldImage{shown_name(sent.name), content};
    if (auto* colours = std::get_if<simulation::PaintByColours>(&choice)) {
        colours->drawing = shown_name(sent.name);
        colours->content = content;
    }
    return choice;
}

/// The file that the choice reads may come with the request.
Painted chosen(const State& state, const JsonReader& request) {
    request.allow_only(
        {"id", "do", "merge", "tiles", "patterns", "palette", "property", "range", "dither", "file"});
    const PaintingText text = read_painting_text(request);
    const auto tiles = chosen_tiles(state, request);
    const auto file = request.find("file");
    if (!file) return by_choice(state, tiles, typed::read_painting(text));
    file->allow_only({"name", "text_base64"});
    if (text.patterns != "image:" && text.patterns != "colours:")
        file->fail("is read only with the patterns 'image:' or 'colours:', not with '" + text.patterns + "'");
    const SentFile sent = parse_sent_file(*file);
    return by_choice(state, tiles, with_file(typed::read_painting(text), sent));
}

}  // namespace

std::vector<std::size_t> read_tiles(const JsonReader& json, const State& state) {
    std::vector<std::size_t> tiles;
    const long long last = static_cast<long long>(state.tile_count()) - 1;
    for (const JsonReader& tile : json.elements()) tiles.push_back(tile.integer(0, last));
    if (tiles.empty()) json.fail("is empty, where at least one tile is needed");
    return tiles;
}

PaintingText read_painting_text(const JsonReader& request) {
    const auto text_of = [&](const char* key) {
        const auto value = request.find(key);
        return value ? read_plain_text(*value) : std::string();
    };
    const auto dither = request.find("dither");
    const bool is_dithered = dither && dither->boolean();
    return {.patterns = text_of("patterns"),
            .palette = text_of("palette"),
            .property = text_of("property"),
            .range = text_of("range"),
            .dither = is_dithered,
            .prefix = ""};
}

std::string kind_of(const simulation::PaintingChoice& recipe) {
    if (std::holds_alternative<simulation::PaintAtRandom>(recipe)) return "random";
    const auto* field = std::get_if<simulation::PaintByField>(&recipe);
    if (field == nullptr) return "colours";
    return std::holds_alternative<simulation::FieldImage>(field->field) ? "image" : "field";
}

Painting painted_again(const State& state) {
    State painted = state;
    for (const simulation::PaintingRecipe& recipe : make_project(state, "/").recipes)
        painted.painting =
            std::make_shared<const Painting>(by_choice(painted, recipe.tiles, recipe.choice).painting);
    return *painted.painting;
}

Painting painted_as(const State& state, const tiling::Tessellation& painted) {
    Painting painting = *state.painting;
    PaletteWriter palette(painting, state.ground->layout);
    for (const TileIndex tile : painted.tiles.indices()) {
        const pattern::NamedPattern* pattern = tiling::pattern_of(painted, tile);
        const int place = pattern == nullptr ? -1 : palette.place_of(*pattern);
        if (place != painting.patterns[tile]) paint_by_hand(painting, tile, place);
    }
    return painting;
}

Painted painted(const State& state, const JsonReader& request) {
    const auto patterns = request.find("patterns");
    if (!patterns) return with_one_pattern(state, request);
    return patterns->is_array() ? tile_by_tile(state, request) : chosen(state, request);
}

}  // namespace fretwork::studio
