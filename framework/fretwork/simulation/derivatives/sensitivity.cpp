// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/derivatives/sensitivity.hpp>
#include <fretwork/simulation/derivatives/setting_rates.hpp>
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/detail/tile_sensitivity.hpp>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace fretwork::simulation {
namespace {

using mechanics::kDofsPerNode;
using mechanics::NodeValues;

/// The rows of nodes as one column.
Eigen::Map<const Eigen::VectorXd> column_of(const NodeValues& rows) {
    return {rows.data(), rows.size()};
}

NodeValues rows_of(const Eigen::VectorXd& column) {
    return Eigen::Map<const NodeValues>(column.data(), column.size() / kDofsPerNode, kDofsPerNode);
}

}  // namespace

namespace detail {

void require_gradient(const NodeValues& gradient, Eigen::Index nodes) {
    if (gradient.rows() != nodes)
        throw base::InputError("the gradient has " + std::to_string(gradient.rows()) +
                               " rows, where one is needed for each of the result's " +
                               std::to_string(nodes) + " nodes");
}

TileSensitivity tile_sensitivity(const TileLinearization& tile, TileAdjoint adjoint,
                                 const Eigen::Vector3d& gravity) {
    TileSensitivity result;
    result.stiffness = std::numeric_limits<double>::quiet_NaN();
    result.own_mass = tile.mass;
    result.mass = (adjoint.motions.leftCols<3>() * gravity).mean();
    if (tile.strains.size() == 0) return result;
    result.strains = tile.strains;
    result.adjoint_strains = std::move(adjoint.strains);
    result.stiffness = -tile.forces.dot(column_of(adjoint.motions));
    result.energy = tile.energy;
    return result;
}

}  // namespace detail

Sensitivity sensitivity(const Linearization& linearization, const NodeValues& gradient,
                        const base::Control& control) {
    detail::require_gradient(gradient, linearization.reported_nodes);
    // Nodes inside of beams, which results leave out, are behind the others.
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(linearization.loads.size(), 1);
    all.topRows(gradient.size()) = column_of(gradient);
    const Eigen::MatrixXd motions = linearization.tangent.adjoint_motions(all, control);
    Sensitivity result;
    result.loads = rows_of(motions.col(0)).topRows(gradient.rows());
    result.held_values =
        rows_of(linearization.tangent.by_held_values(all, motions).col(0)).topRows(gradient.rows());
    result.stiffness = -column_of(linearization.loads).dot(motions.col(0));
    for (const TileLinearization& tile : linearization.tiles) {
        detail::TileAdjoint adjoint{detail::rows_of_tile(result.loads, tile.nodes), {}};
        if (tile.strains.size() > 0) adjoint.strains = tile.slopes * column_of(adjoint.motions);
        result.tiles.push_back(detail::tile_sensitivity(tile, std::move(adjoint), linearization.gravity));
    }
    return result;
}

Sensitivity with_energy(Sensitivity by, double weight, double energy) {
    // At fixed nodes, dU = e . dK e / 2. With dJ = -a . dK e, U has the adjoint strains a = -e / 2.
    for (TileSensitivity& tile : by.tiles) {
        if (tile.strains.size() == 0) continue;
        tile.adjoint_strains -= 0.5 * weight * tile.strains;
        tile.stiffness += weight * tile.energy;
    }
    by.stiffness += weight * energy;
    return by;
}

Eigen::MatrixXd pattern_derivatives(const Sensitivity& sensitivity, const CandidateTiles& candidates) {
    const auto patterns = std::ssize(candidates.patterns());
    Eigen::MatrixXd result(std::ssize(sensitivity.tiles), patterns);
    std::vector<std::vector<tiling::TileIndex>> members(candidates.class_count());
    for (const tiling::TileIndex tile : sensitivity.tiles.indices())
        members[candidates.class_of(tile)].push_back(tile);
    for (std::size_t c = 0; c < members.size(); ++c) {
        Eigen::MatrixXd forms(candidates.packed(c).rows(), std::ssize(members[c]));
        for (std::size_t i = 0; i < members[c].size(); ++i) {
            const TileSensitivity& tile = sensitivity.tiles[members[c][i]];
            auto form = forms.col(static_cast<Eigen::Index>(i));
            if (tile.strains.size() == 0) {
                form.setConstant(std::numeric_limits<double>::quiet_NaN());
            } else {
                form = CandidateTiles::pack_form(tile.adjoint_strains, tile.strains);
            }
        }
        const Eigen::MatrixXd forms_of_all = forms.transpose() * candidates.packed(c);
        for (std::size_t i = 0; i < members[c].size(); ++i) {
            const TileSensitivity& tile = sensitivity.tiles[members[c][i]];
            auto row = result.row(members[c][i].value);
            row = -forms_of_all.row(static_cast<Eigen::Index>(i)).array() - tile.stiffness;
            if (tile.mass == 0.0) continue;
            for (Eigen::Index p = 0; p < patterns; ++p)
                row[p] += tile.mass * (candidates.mass(c, p) - tile.own_mass);
        }
    }
    return result;
}

double derivative_along(const Sensitivity& sensitivity, const Surface& surface,
                        const std::function<reduction::Setting(double)>& setting, double step) {
    for (const TileSensitivity& own : sensitivity.tiles) {
        if (own.strains.size() == 0) return std::numeric_limits<double>::quiet_NaN();
    }
    const auto rates = rates_along(surface, setting, step);
    double sum = 0.0;
    for (const tiling::TileIndex tile : rates.indices()) {
        const TileSensitivity& own = sensitivity.tiles[tile];
        const TileRate& rate = *rates[tile];
        sum += own.mass * rate.mass -
               own.adjoint_strains.dot(rate.stiffness.selfadjointView<Eigen::Lower>() * own.strains);
    }
    return sum;
}

}  // namespace fretwork::simulation
