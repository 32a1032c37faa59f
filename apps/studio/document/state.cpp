// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/simulation/internal/origins.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <studio/document/state.hpp>

#include <map>
#include <set>

namespace fretwork::studio {
namespace {

using simulation::Project;

template <class Value>
State::Part<Value> part(Value value) {
    return std::make_shared<const Value>(std::move(value));
}

std::vector<std::string> tile_models_of(const Project& project) {
    std::vector<std::string> models = simulation::models_by_tile(project);
    models.resize(project.tessellation.tiles.size());
    return models;
}

using Recipe = std::shared_ptr<const simulation::PaintingChoice>;

/// The size of the image or the drawing that a choice has with it, in bytes.
std::size_t size_of_file(const simulation::PaintingChoice& choice) {
    const auto* field = std::get_if<simulation::PaintByField>(&choice);
    const auto* image = field == nullptr ? nullptr : std::get_if<simulation::FieldImage>(&field->field);
    if (image != nullptr && image->content) return image->content->bytes.size();
    const auto* colours = std::get_if<simulation::PaintByColours>(&choice);
    return colours != nullptr && colours->content ? colours->content->bytes.size() : 0;
}

/// The files of recipes that another painting does not have.
std::size_t size_of_files(const Painting& painting, const Painting& other) {
    std::set<Recipe> known(other.recipes.begin(), other.recipes.end());
    std::size_t size = 0;
    for (const Recipe& recipe : painting.recipes) {
        if (known.insert(recipe).second && recipe) size += size_of_file(*recipe);
    }
    return size;
}

std::vector<Recipe> recipes_by_tile(const Project& project) {
    std::vector<Recipe> recipes(project.tessellation.tiles.size());
    for (const simulation::PaintingRecipe& recipe : project.recipes) {
        const Recipe shared = part(recipe.choice);
        for (const tiling::TileIndex tile : recipe.tiles) recipes[tile] = shared;
    }
    return recipes;
}

/// The inverse, in the order of the recipes' first tiles.
std::vector<simulation::PaintingRecipe> recipes_with_tiles(const Painting& painting) {
    std::vector<simulation::PaintingRecipe> recipes;
    std::map<const simulation::PaintingChoice*, std::size_t> places;
    for (std::size_t t = 0; t < painting.recipes.size(); ++t) {
        const Recipe& recipe = painting.recipes[t];
        if (!recipe) continue;
        const auto [place, is_new] = places.try_emplace(recipe.get(), recipes.size());
        if (is_new) recipes.push_back({*recipe, {}});
        recipes[place->second].tiles.emplace_back(t);
    }
    return recipes;
}

std::size_t size_of_difference(const Painting& painting, const Painting& other) {
    return (painting.patterns.size() + painting.turns.size()) * sizeof(int) +
           painting.recipes.size() * sizeof(painting.recipes.front()) + 64 * painting.palette.size() +
           size_of_files(painting, other);
}

std::size_t size_of(const std::vector<simulation::LoadCase>& load_cases) {
    std::size_t size = 0;
    for (const simulation::LoadCase& load_case : load_cases)
        size += simulation::load_case_text(load_case).size();
    return size;
}

}  // namespace

State make_state(const Project& project, const std::filesystem::path& folder) {
    Painting painting{project.tessellation.patterns, {}, {}, {}};
    for (const tiling::Tile& tile : project.tessellation.tiles) painting.patterns.push_back(tile.pattern);
    painting.turns.resize(painting.patterns.size());
    painting.recipes = recipes_by_tile(project);
    LibraryLink library;
    if (!project.library_path.empty()) {
        library.path = std::filesystem::absolute(folder / project.library_path).lexically_normal();
        library.hash = project.library_hash;
    }
    // The page numbers entries as load_case_json() lists them.
    std::vector<simulation::LoadCase> load_cases = project.load_cases;
    for (simulation::LoadCase& load_case : load_cases)
        load_case = simulation::without_origins(std::move(load_case));
    return {.ground = part(project),
            .painting = part(std::move(painting)),
            .tile_models = part(tile_models_of(project)),
            .load_cases = part(std::move(load_cases)),
            .setting = part(project.setting.value_or(reduction::paper_setting())),
            .library = part(std::move(library)),
            .model = part(first_model())};
}

Project make_project(const State& state, const std::filesystem::path& folder) {
    Project project = *state.ground;
    tiling::Tessellation& tessellation = project.tessellation;
    tessellation.patterns = state.painting->palette;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) {
        tessellation.tiles[t].pattern = state.painting->patterns[t];
        tiling::turn(tessellation.tiles[t], state.painting->turns[t]);
    }
    project.recipes = recipes_with_tiles(*state.painting);
    project.load_cases = *state.load_cases;
    project.setting = *state.setting;
    project.tile_models = simulation::tile_model_choices(*state.tile_models);
    const LibraryLink& library = *state.library;
    project.library_hash = library.hash;
    project.library_path =
        library.path.empty()
            ? ""
            : library.path.lexically_relative(std::filesystem::absolute(folder).lexically_normal())
                  .generic_string();
    return project;
}

std::string first_model() {
    const auto fits = [](const reduction::TileModel& model) {
        return model.parameters.empty() && model.role == reduction::Role::Reduced;
    };
    const std::vector<reduction::TileModel>& models = reduction::tile_models();
    std::string chosen = models.front().name;
    bool is_large = false;
    for (const reduction::TileModel& model : models) {
        const bool is_for_large = model.displacements == reduction::Displacements::Large;
        if (!fits(model) || (is_large && !is_for_large)) continue;
        chosen = model.name;
        is_large = is_for_large;
    }
    return chosen;
}

std::size_t size_of_difference(const State& state, const State& other) {
    std::size_t size = sizeof(State);
    if (state.ground != other.ground) size += 400 * state.tile_count();
    if (state.painting != other.painting) size += size_of_difference(*state.painting, *other.painting);
    if (state.tile_models != other.tile_models) size += sizeof(std::string) * state.tile_models->size();
    if (state.load_cases != other.load_cases) size += size_of(*state.load_cases);
    if (state.setting != other.setting) size += sizeof(reduction::Setting);
    return size;
}

}  // namespace fretwork::studio
