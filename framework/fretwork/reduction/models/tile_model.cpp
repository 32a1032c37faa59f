// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/reduction/detail/rigid_motions.hpp>
#include <fretwork/reduction/models/tile_model.hpp>

#include <algorithm>

namespace fretwork::reduction {

std::shared_ptr<const TileStructure> build_tile(const TileModel& model, const TileInput& input) {
    auto tile = model.build(input);
    detail::require_free_motion(*tile, model, input);
    return tile;
}

const TileModel& find_tile_model(std::string_view name, std::span<const TileModel> models) {
    const auto row = std::ranges::find(models, name, &TileModel::name);
    if (row != models.end()) return *row;
    std::vector<std::string> names;
    for (const TileModel& model : models) names.push_back(model.name);
    throw base::InputError(base::unknown_name_message("tile model", name, names));
}

std::size_t parameter_index(const TileModel& model, std::string_view name) {
    const auto place = std::ranges::find(model.parameters, name, &TileParameter::name);
    if (place != model.parameters.end()) return place - model.parameters.begin();
    std::vector<std::string> names;
    for (const TileParameter& parameter : model.parameters) names.push_back(parameter.name);
    throw base::InputError("tile model " + model.name + ": " +
                           base::unknown_name_message("parameter", name, names));
}

}  // namespace fretwork::reduction
