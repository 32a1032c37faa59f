// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/named.hpp>
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
    return base::find_named(name, models, &TileModel::name, "tile model");
}

std::size_t parameter_index(const TileModel& model, std::string_view name) {
    const auto place = std::ranges::find(model.parameters, name, &TileParameter::name);
    if (place != model.parameters.end()) return place - model.parameters.begin();
    throw base::InputError("tile model " + model.name + ": " +
                           base::unknown_name_message(
                               "parameter", name, base::names_of(model.parameters, &TileParameter::name)));
}

}  // namespace fretwork::reduction
