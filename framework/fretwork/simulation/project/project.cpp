// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/load_cases/combination.hpp>
#include <fretwork/simulation/project/project.hpp>

#include <map>
#include <string>
#include <utility>

namespace fretwork::simulation {

LoadCase find_load_case(const Project& project, const std::string& name) {
    if (name.empty() && project.load_cases.size() == 1)
        return combined(project.load_cases.front(), project.load_cases);
    if (project.load_cases.empty())
        throw base::InputError("the project has no load case yet; add one with 'fretwork case add'");
    if (!name.empty()) return combined(load_case_of(name, project.load_cases), project.load_cases);
    const auto names = base::names_of(project.load_cases, &LoadCase::name);
    throw base::InputError("the project has several load cases; choose one: " + base::join(names, ", "));
}

std::vector<std::string> models_by_tile(const Project& project) {
    std::vector<std::string> models;
    if (project.tile_models.empty()) return models;
    models.resize(project.tessellation.tiles.size());
    for (const Project::TileModelChoice& choice : project.tile_models) {
        for (const tiling::TileIndex tile : choice.tiles) {
            if (!project.tessellation.tiles.has(tile))
                throw base::InputError("tile_models", "",
                                       "there is no tile " + std::to_string(tile.value) +
                                           ": tiles run from 0 to " + std::to_string(models.size() - 1));
            models[tile] = choice.model;
        }
    }
    return models;
}

std::vector<Project::TileModelChoice> tile_model_choices(const std::vector<std::string>& models) {
    std::map<std::string, std::vector<tiling::TileIndex>> tiles;
    for (std::size_t t = 0; t < models.size(); ++t) {
        if (!models[t].empty()) tiles[models[t]].emplace_back(t);
    }
    std::vector<Project::TileModelChoice> choices;
    for (auto& [model, chosen] : tiles) choices.push_back({model, std::move(chosen)});
    return choices;
}

}  // namespace fretwork::simulation
