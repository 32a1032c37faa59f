// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casters.hpp"

#include <fretwork/reduction/models/tile_model.hpp>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace fretwork::python {

/// The input from which a function in Python builds a tile. The function may keep it, because nothing is
/// borrowed.
struct OwnedTileInput {
    pattern::NodeLayout layout;
    pattern::Fan fan;
    reduction::Setting setting;
    geometry::Polygon polygon;
    std::vector<double> parameters;
};

using BuildFunction = std::function<py::object(const OwnedTileInput&)>;

/// A tile from a function in Python, which returns a TileStructure, or the stiffness of the n interface nodes
/// (6n x 6n). Throws InputError if the stiffness has another size, is not symmetric, or has a number that is
/// not finite.
std::shared_ptr<const reduction::TileStructure> build_in_python(const BuildFunction& build,
                                                                const reduction::TileInput& input);

/// Takes `models` out of the keywords of a call. Returns the catalogue of the framework with these models. A
/// model replaces the row with its name; a model with a new name is added.
std::vector<reduction::TileModel> taken_models(py::dict& named);
/// The catalogue with these models, as taken_models(); none: the catalogue alone.
std::vector<reduction::TileModel> models_or_all(
    const std::optional<std::vector<reduction::TileModel>>& models);

/// A tile model, or its name.
using ModelOrName = std::variant<std::string, reduction::TileModel>;
/// The tile model. Throws InputError if the catalogue has no model with this name.
reduction::TileModel model_of(const ModelOrName& given);

}  // namespace fretwork::python
