// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/project/new_project.hpp>
#include <fretwork/simulation/project/painting_recipe.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/simulation/project/retiling.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace fretwork::simulation {
namespace {

using geometry::Point2;
using tiling::Tessellation;
using tiling::TileIndex;

/// Finds the tile of a tessellation whose centroid is nearest to a place.
class NearestTile {
  public:
    explicit NearestTile(const Tessellation& tessellation) {
        const auto centers = tiling::tile_centers(tessellation);
        for (const TileIndex tile : centers.indices()) sorted_.push_back({centers[tile], tile});
        std::ranges::sort(sorted_, {}, [](const Entry& entry) { return entry.place.x; });
    }
    /// Looks to the right, then to the left, until the distance in x alone exceeds the best distance.
    [[nodiscard]] TileIndex operator()(const Point2& place) const {
        const auto begin =
            std::ranges::lower_bound(sorted_, place.x, {}, [](const Entry& entry) { return entry.place.x; });
        Best best;
        for (auto entry = begin; entry != sorted_.end() && entry->place.x - place.x <= best.distance; ++entry)
            best.look_at(*entry, place);
        for (auto entry = begin; entry != sorted_.begin() && place.x - (entry - 1)->place.x <= best.distance;
             --entry)
            best.look_at(*(entry - 1), place);
        return best.tile;
    }

  private:
    struct Entry {
        Point2 place;
        TileIndex tile;
    };
    struct Best {
        double distance = std::numeric_limits<double>::infinity();
        TileIndex tile{};
        void look_at(const Entry& entry, const Point2& place) {
            const double away = geometry::distance(entry.place, place);
            if (std::pair(away, entry.tile.value) < std::pair(distance, tile.value))
                *this = {away, entry.tile};
        }
    };
    std::vector<Entry> sorted_;
};

using FromTiles = base::IndexVector<TileIndex, TileIndex>;

FromTiles nearest_tiles(const Tessellation& old_tiles, const Tessellation& new_tiles) {
    const NearestTile nearest(old_tiles);
    FromTiles from;
    for (const Point2& center : tiling::tile_centers(new_tiles)) from.push_back(nearest(center));
    return from;
}

template <class Entry>
bool is_by_number(const Entry& entry) {
    return std::holds_alternative<NodesById>(entry.where);
}

template <class Entry>
int drop_numbers(std::vector<Entry>& entries) {
    return static_cast<int>(std::erase_if(entries, is_by_number<Entry>));
}

/// An entry of a file is one row for each prescribed component.
int drop_numbers(std::vector<LoadCase::PrescribedDisplacement>& rows) {
    int entries = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool continues = i > 0 && rows[i].where == rows[i - 1].where;
        if (is_by_number(rows[i]) && !continues) ++entries;
    }
    std::erase_if(rows, is_by_number<LoadCase::PrescribedDisplacement>);
    return entries;
}

/// The new tiles that come from some old ones.
LoadCase::AreaLoad::Tiles tiles_from(const LoadCase::AreaLoad::Tiles& old_tiles, const FromTiles& from) {
    LoadCase::AreaLoad::Tiles tiles;
    for (const TileIndex tile : from.indices()) {
        if (std::ranges::find(old_tiles.numbers, static_cast<int>(from[tile].value)) !=
            old_tiles.numbers.end())
            tiles.numbers.push_back(static_cast<int>(tile.value));
    }
    return tiles;
}

int drop_area_numbers(std::vector<LoadCase::AreaLoad>& loads) {
    return static_cast<int>(std::erase_if(loads, [](const LoadCase::AreaLoad& load) {
        const auto* where = std::get_if<Selection>(&load.where);
        return where != nullptr && std::holds_alternative<NodesById>(*where);
    }));
}

/// Returns the number of removed loads: no new tile bears them.
int carry_tile_loads(std::vector<LoadCase::AreaLoad>& loads, const FromTiles& from) {
    return static_cast<int>(std::erase_if(loads, [&](LoadCase::AreaLoad& load) {
        auto* tiles = std::get_if<LoadCase::AreaLoad::Tiles>(&load.where);
        if (tiles == nullptr) return false;
        *tiles = tiles_from(*tiles, from);
        return tiles->numbers.empty();
    }));
}

void drop_node_numbers(LoadCase& load_case, DroppedEntries& dropped) {
    dropped.supports += drop_numbers(load_case.supports);
    dropped.loads += drop_numbers(load_case.loads) + drop_area_numbers(load_case.area_loads);
    dropped.prescribed += drop_numbers(load_case.prescribed);
}

std::vector<Project::TileModelChoice> carried_models(const Project& project, const FromTiles& from) {
    const std::vector<std::string> models = models_by_tile(project);
    if (models.empty()) return {};
    std::vector<std::string> carried;
    for (const TileIndex tile : from) carried.push_back(models[tile]);
    return tile_model_choices(carried);
}

std::vector<PaintingRecipe> carried_recipes(const Project& project, const FromTiles& from) {
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    base::IndexVector<TileIndex, std::size_t> recipe_of_old(project.tessellation.tiles.size(), kNone);
    std::vector<PaintingRecipe> carried;
    for (const PaintingRecipe& recipe : project.recipes) {
        for (const TileIndex tile : recipe.tiles) recipe_of_old[tile] = carried.size();
        carried.push_back({recipe.choice, {}});
    }
    for (const TileIndex tile : from.indices()) {
        const std::size_t recipe = recipe_of_old[from[tile]];
        if (recipe != kNone) carried[recipe].tiles.push_back(tile);
    }
    std::erase_if(carried, [](const PaintingRecipe& recipe) { return recipe.tiles.empty(); });
    return carried;
}

}  // namespace

NewTiles new_tiles(const Project& project, const RetilingOptions& options) {
    const reduction::Setting setting = project.setting.value_or(reduction::paper_setting());
    std::vector<outlines::Outline> parts{project.outline};
    parts.insert(parts.end(), project.further_outlines.begin(), project.further_outlines.end());
    const double edge_length = options.edge_length.value_or(tiling::mean_tile_side(project.tessellation));
    tiling::TessellationOptions wanted = tiling_options(setting, edge_length, options.angle);
    wanted.narrow = options.narrow;
    wanted.control = options.control;
    NewTiles made;
    made.layout = options.layout.value_or(project.layout);
    tiling::TessellationResult result = tiling::tessellate_parts(parts, made.layout, wanted);
    made.tessellation = std::move(result.tessellation);
    made.report = result.report;
    return made;
}

CarriedOver carry_over(const Project& project, const NewTiles& tiles) {
    CarriedOver carried{project, nearest_tiles(project.tessellation, tiles.tessellation), {}};
    Project& next = carried.project;
    next.layout = tiles.layout;
    next.tessellation = tiles.tessellation;
    next.tile_models = carried_models(project, carried.from);
    if (tiles.layout == project.layout) {
        next.tessellation.patterns = project.tessellation.patterns;
        for (const TileIndex tile : carried.from.indices())
            next.tessellation.tiles[tile].pattern = project.tessellation.tiles[carried.from[tile]].pattern;
        next.recipes = carried_recipes(project, carried.from);
    } else {
        next.recipes.clear();
        next.library_path.clear();
        next.library_hash.clear();
    }
    const bool has_same_nodes = next.tessellation.interface_nodes == project.tessellation.interface_nodes;
    for (LoadCase& load_case : next.load_cases) {
        carried.dropped.loads += carry_tile_loads(load_case.area_loads, carried.from);
        if (!has_same_nodes) drop_node_numbers(load_case, carried.dropped);
        check_selections(load_case, next.tessellation);
    }
    return carried;
}

RetiledProject retile(const Project& project, const RetilingOptions& options,
                      const library::Library* library) {
    const NewTiles tiles = new_tiles(project, options);
    if (library != nullptr) library->check_layout(tiles.layout);
    CarriedOver carried = carry_over(project, tiles);
    Project& next = carried.project;
    // With colours, tiles beside the drawing keep their patterns.
    const bool leaves_tiles = std::holds_alternative<std::monostate>(options.painting) ||
                              std::holds_alternative<PaintByColours>(options.painting);
    if (leaves_tiles) apply_recipes(next, library);
    std::vector<TileIndex> painted = paint(next, options.painting, library);
    return {std::move(next), tiles.report, carried.dropped, std::move(carried.from), std::move(painted)};
}

}  // namespace fretwork::simulation
