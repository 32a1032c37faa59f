// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/design/search/joint_swaps.hpp>

#include <Eigen/Dense>

namespace fretwork::design::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// dk times a matrix whose rows are strains of one tile.
void times_change(const TileSwap& swap, const MatrixXd& strains, Eigen::Ref<MatrixXd> result) {
    const Index half = swap.from.in_plane.rows();
    result.topRows(half).noalias() = (swap.to.in_plane - swap.from.in_plane) * strains.topRows(half);
    result.bottomRows(half).noalias() =
        (swap.to.out_of_plane - swap.from.out_of_plane) * strains.bottomRows(half);
}

}  // namespace

JointAnswer joint_answer(const CaseModel& model, std::span<const TileSwap> swaps) {
    std::vector<Index> places;
    Index size = 0;
    for (const TileSwap& own : swaps) {
        places.push_back(size);
        size += model.tiles[own.tile].strains.size();
    }
    // Rows of each tile: (1 + dk G) f = -dk e.
    MatrixXd flexibility(size, size);
    MatrixXd matrix(size, size);
    VectorXd right(size);
    for (std::size_t i = 0; i < swaps.size(); ++i) {
        const VectorXd& strains = model.tiles[swaps[i].tile].strains;
        for (std::size_t j = 0; j < swaps.size(); ++j) {
            const Index columns = model.tiles[swaps[j].tile].strains.size();
            flexibility.block(places[i], places[j], strains.size(), columns) = model.flexibility.block(
                model.first[swaps[i].tile], model.first[swaps[j].tile], strains.size(), columns);
        }
        times_change(swaps[i], flexibility.middleRows(places[i], strains.size()),
                     matrix.middleRows(places[i], strains.size()));
        times_change(swaps[i], -strains, right.segment(places[i], strains.size()));
    }
    matrix.diagonal().array() += 1.0;
    const VectorXd stress = Eigen::PartialPivLU<Eigen::Ref<MatrixXd>>(matrix).solve(right);
    JointAnswer answer{VectorXd::Zero(model.residual.size()), stress.dot(flexibility * stress)};
    for (std::size_t i = 0; i < swaps.size(); ++i) {
        const CaseModel::Tile& tile = model.tiles[swaps[i].tile];
        answer.residuals +=
            tile.reach * stress.segment(places[i], tile.strains.size()) + swaps[i].mass * tile.of_weight;
    }
    return answer;
}

}  // namespace fretwork::design::detail
