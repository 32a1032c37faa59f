// SPDX-License-Identifier: GPL-3.0-or-later
// Selected inversion [Erisman1975], by supernodes. With L_P the unit lower triangle of a supernode's own
// columns, L_R the rows below them and D the pivots, the inverse Z of the whole matrix has, on the
// supernode's front,
//   Z_RP = -Z_RR Y,  Z_PP = L_P^-T D^-1 L_P^-1 - Y^T Z_RP,  Y = L_R L_P^-1,
// and Z_RR is a part of Z on the parent's front. The cost is about three factorizations.
#include <fretwork/base/index.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>

#include <Eigen/Dense>

#include <algorithm>

namespace fretwork::mechanics::sparse {
namespace {

using base::at;
using Panel = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

/// Fill in the supernode's own rows and columns of the inverse on its front. Pre: the rows and columns below
/// them are filled in.
void complete_inverse(const Front& front, Eigen::MatrixXd& inverse) {
    const Eigen::Index width = front.width;
    const Eigen::Index rows = front.rows;
    const Panel own(front.panel, width, width, Eigen::OuterStride<>(width + rows));
    const Panel below(front.panel + width, rows, width, Eigen::OuterStride<>(width + rows));
    const Eigen::MatrixXd triangle =
        own.triangularView<Eigen::UnitLower>().solve(Eigen::MatrixXd::Identity(width, width));
    inverse.topLeftCorner(width, width).noalias() =
        triangle.transpose() * own.diagonal().cwiseInverse().asDiagonal() * triangle;
    if (rows == 0) return;
    const Eigen::MatrixXd spread = below * triangle;  // Y
    auto coupling = inverse.bottomLeftCorner(rows, width);
    coupling.noalias() = -inverse.bottomRightCorner(rows, rows) * spread;
    inverse.topLeftCorner(width, width).noalias() -= spread.transpose() * coupling;
    inverse.topRightCorner(width, rows) = coupling.transpose();
}

/// The places of equations in the front of a supernode.
std::vector<Eigen::Index> places_in_front(const SupernodeTree& tree, const Supernode& supernode,
                                          std::span<const int> equations) {
    const auto rows = std::span(tree.row).subspan(supernode.row_start, at(supernode.rows));
    std::vector<Eigen::Index> places;
    for (const int equation : equations) {
        const int own = equation - supernode.first;
        places.push_back(own < supernode.width
                             ? own
                             : supernode.width + (std::ranges::lower_bound(rows, equation) - rows.begin()));
    }
    return places;
}

}  // namespace

std::vector<Eigen::MatrixXd> Ldlt::inverse_blocks(std::span<const std::vector<int>> cliques,
                                                  const base::Control& control) const {
    const SupernodeTree& tree = analysis_->tree;
    const std::size_t count = tree.supernodes.size();
    std::vector<std::vector<std::size_t>> cliques_at(count);
    const auto starts_after = [](int equation, const Supernode& supernode) {
        return equation < supernode.first;
    };
    for (std::size_t c = 0; c < cliques.size(); ++c) {
        if (cliques[c].empty()) continue;
        const int first = std::ranges::min(cliques[c]);
        const auto after =
            std::upper_bound(tree.supernodes.begin(), tree.supernodes.end(), first, starts_after);
        cliques_at[after - tree.supernodes.begin() - 1].push_back(c);
    }
    std::vector<Eigen::MatrixXd> inverse(count);  // inverse on each front, kept as long as a child needs it
    std::vector<int> waiting(count);
    for (std::size_t s = 0; s < count; ++s) waiting[s] = tree.child_start[s + 1] - tree.child_start[s];
    std::vector<Eigen::MatrixXd> blocks(cliques.size());
    for (std::size_t s = count; s-- > 0;) {
        control.check();
        const Supernode& own = tree.supernodes[s];
        inverse[s].resize(own.height(), own.height());
        if (own.parent >= 0) {
            const Eigen::Map<const Eigen::VectorXi> place(tree.place.data() + own.row_start, own.rows);
            inverse[s].bottomRightCorner(own.rows, own.rows) = inverse[at(own.parent)](place, place);
            if (--waiting[at(own.parent)] == 0) inverse[at(own.parent)].resize(0, 0);
        }
        complete_inverse(front_of(s), inverse[s]);
        for (const std::size_t c : cliques_at[s]) {
            const auto places = places_in_front(tree, own, cliques[c]);
            blocks[c] = inverse[s](places, places);
        }
        if (waiting[s] == 0) inverse[s].resize(0, 0);
    }
    return blocks;
}

}  // namespace fretwork::mechanics::sparse
