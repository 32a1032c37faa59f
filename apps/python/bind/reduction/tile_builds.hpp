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

/// A tile from a function in Python, which returns a TileStructure, or the stiffness of the interface nodes.
std::shared_ptr<const reduction::TileStructure> build_in_python(const BuildFunction& build,
                                                                const reduction::TileInput& input);

/// Takes `models` out of the keywords of a call. Returns all models of the framework, with these added, or in
/// the place of those with the same name.
std::vector<reduction::TileModel> taken_models(py::dict& named);
std::vector<reduction::TileModel> models_or_all(
    const std::optional<std::vector<reduction::TileModel>>& models);

/// A tile model, or its name.
using ModelOrName = std::variant<std::string, reduction::TileModel>;
reduction::TileModel model_of(const ModelOrName& given);

}  // namespace fretwork::python
