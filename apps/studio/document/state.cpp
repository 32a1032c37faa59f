// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <studio/document/painting_request.hpp>
#include <studio/document/state.hpp>

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

/// The files of recipes that another painting does not have.
std::size_t size_of_files(const Painting& painting, const Painting& other) {
    std::set<std::shared_ptr<const PaintingRecipe>> known(other.recipes.begin(), other.recipes.end());
    std::size_t size = 0;
    for (const auto& recipe : painting.recipes) {
        if (known.insert(recipe).second && recipe && recipe->file) size += recipe->file->content.size();
    }
    return size;
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
    painting.recipes.resize(painting.patterns.size());
    LibraryLink library;
    if (!project.library_path.empty()) {
        library.path = std::filesystem::absolute(folder / project.library_path).lexically_normal();
        library.hash = project.library_hash;
    }
    return {.ground = part(project),
            .painting = part(std::move(painting)),
            .tile_models = part(tile_models_of(project)),
            .load_cases = part(project.load_cases),
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
