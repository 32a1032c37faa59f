// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bind.hpp"
#include "reduction/tile_builds.hpp"

#include <fretwork/base/error.hpp>

#include <algorithm>

namespace fretwork::python {

using namespace reduction;

std::shared_ptr<const TileStructure> build_in_python(const BuildFunction& build, const TileInput& input) {
    const py::gil_scoped_acquire acquired;
    const py::object made = build({input.layout,
                                   input.fan,
                                   input.setting,
                                   input.polygon,
                                   {input.parameters.begin(), input.parameters.end()}});
    if (py::isinstance<TileStructure>(made)) return made.cast<std::shared_ptr<TileStructure>>();
    const auto stiffness = made.cast<Eigen::MatrixXd>();
    const Eigen::Index rows = 6 * input.fan->interface_node_count;
    if (stiffness.rows() != rows || stiffness.cols() != rows)
        throw base::InputError("a tile of " + std::to_string(input.fan->interface_node_count) +
                               " interface nodes has a stiffness of " + std::to_string(rows) + " x " +
                               std::to_string(rows) + " numbers, not " + std::to_string(stiffness.rows()) +
                               " x " + std::to_string(stiffness.cols()));
    if (!stiffness.allFinite())
        throw base::InputError("the stiffness of a tile has a number that is not finite");
    if (!stiffness.isApprox(stiffness.transpose(), 1e-9))
        throw base::InputError("the stiffness of a tile is not symmetric");
    return stiffness_tile(stiffness);
}

std::vector<TileModel> models_or_all(const std::optional<std::vector<TileModel>>& models) {
    std::vector<TileModel> all = tile_models();
    if (!models) return all;
    for (const TileModel& own : *models) {
        const auto same = std::ranges::find(all, own.name, &TileModel::name);
        if (same == all.end())
            all.push_back(own);
        else
            *same = own;
    }
    return all;
}

std::vector<TileModel> taken_models(py::dict& named) {
    const py::object given = taken(named, "models");
    if (given.is_none()) return tile_models();
    return models_or_all(given.cast<std::vector<TileModel>>());
}

TileModel model_of(const ModelOrName& given) {
    if (std::holds_alternative<TileModel>(given)) return std::get<TileModel>(given);
    return find_tile_model(std::get<std::string>(given));
}

}  // namespace fretwork::python
