// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/random.hpp>
#include <fretwork/design/search/case_model.hpp>
#include <fretwork/simulation/load_cases/selection.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace fretwork::design::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using simulation::Linearization;
using simulation::TileLinearization;
using tiling::TileIndex;

constexpr Index kDofs = mechanics::kDofsPerNode;
/// The number of random swaps of each tile, of which superpositions are made.
constexpr std::size_t kSwapsOfATile = 4;
/// Directions with responses below this share of the largest one are rounding.
constexpr double kSmallDirection = 1e-9;

/// The weighted changes of the residuals by motions (displacements and rotation vectors), a column each.
MatrixXd observed(const std::vector<Observation>& observations, double scale, const MatrixXd& motions) {
    MatrixXd result(std::ssize(observations), motions.cols());
    for (Index i = 0; i < result.rows(); ++i) {
        const Observation& own = observations[static_cast<std::size_t>(i)];
        result.row(i) = scale * std::sqrt(own.weight) * own.direction.transpose() *
                        motions.middleRows<kDofs>(kDofs * own.node);
    }
    return result;
}

/// The transpose of observed(): gradients of combinations of the residuals, a column each.
MatrixXd gradients_of(const std::vector<Observation>& observations, double scale,
                      const MatrixXd& combinations, Index rows) {
    MatrixXd result = MatrixXd::Zero(rows, combinations.cols());
    for (Index i = 0; i < combinations.rows(); ++i) {
        const Observation& own = observations[static_cast<std::size_t>(i)];
        result.middleRows<kDofs>(kDofs * own.node) +=
            scale * std::sqrt(own.weight) * own.direction * combinations.row(i);
    }
    return result;
}

void add_at_nodes(const TileLinearization& tile, const VectorXd& forces, Eigen::Ref<VectorXd> all) {
    for (Index i = 0; i < std::ssize(tile.nodes); ++i)
        all.segment<kDofs>(kDofs * tile.nodes[static_cast<std::size_t>(i)].value) +=
            forces.segment<kDofs>(kDofs * i);
}

MatrixXd at_nodes(const TileLinearization& tile, const MatrixXd& all) {
    MatrixXd own(kDofs * std::ssize(tile.nodes), all.cols());
    for (Index i = 0; i < std::ssize(tile.nodes); ++i)
        own.middleRows<kDofs>(kDofs * i) =
            all.middleRows<kDofs>(kDofs * tile.nodes[static_cast<std::size_t>(i)].value);
    return own;
}

class CaseLinearizer {
  public:
    CaseLinearizer(const CaseState& state, const SwapSample& sample, const base::Control& control)
        : state_(state),
          sample_(sample),
          control_(control),
          linear_(state.session.linearize(simulation::TileQuantities::StrainsAndFlexibilities, control)),
          observations_(state.goals.observe(state.displacements, state.aim)) {}

    CaseModel model() {
        take_tiles();
        const MatrixXd basis = choose_basis();
        const VectorXd residuals = weighted_residuals();
        model_.residual = basis.transpose() * residuals;
        model_.unreached = std::max(0.0, residuals.squaredNorm() - model_.residual.squaredNorm());
        const MatrixXd gradients = gradients_of(observations_, state_.scale, basis, linear_.loads.size());
        const MatrixXd adjoint = linear_.tangent.adjoint_motions(gradients, control_);
        take_reach(adjoint);
        const Eigen::Map<const VectorXd> loads(state_.unit_loads.data(), state_.unit_loads.size());
        model_.by_loads = adjoint.topRows(loads.size()).transpose() * loads;
        take_prescribed(gradients, adjoint);
        if (sample_.between_tiles) take_flexibility();
        return std::move(model_);
    }

  private:
    [[nodiscard]] std::size_t class_of(TileIndex tile) const { return sample_.candidates.class_of(tile); }
    [[nodiscard]] const MatrixXd& basis_of(TileIndex tile) const {
        return sample_.strains.basis(class_of(tile));
    }

    void take_tiles() {
        model_.tiles.resize(linear_.tiles.size());
        base::parallel_for(linear_.tiles.size(), sample_.threads, [&](std::size_t t) {
            control_.check();
            const TileLinearization& own = linear_.tiles[t];
            const MatrixXd& strains = basis_of(TileIndex(t));
            model_.tiles[t].strains = strains.transpose() * own.strains;
            model_.tiles[t].flexibility = strains.transpose() * own.flexibility * strains;
        });
        for (const TileIndex tile : model_.tiles.indices()) {
            const auto& stiffness =
                stiffness_of(tile, sample_.painting[static_cast<std::size_t>(tile.value)]);
            const VectorXd& strains = model_.tiles[tile].strains;
            const Index half = strains.size() / 2;
            model_.energy += 0.5 * (strains.head(half).dot(stiffness.in_plane * strains.head(half)) +
                                    strains.tail(half).dot(stiffness.out_of_plane * strains.tail(half)));
        }
    }

    [[nodiscard]] const TileStrains::Blocks& stiffness_of(TileIndex tile, std::size_t pattern) const {
        return sample_.strains.stiffness(class_of(tile), pattern);
    }

    /// Forces on the structure: a column for each random superposition of swaps; the last one has the loads.
    MatrixXd random_swaps(Index count) {
        std::vector<std::array<VectorXd, kSwapsOfATile>> forces(model_.tiles.size());
        base::parallel_for(forces.size(), sample_.threads, [&](std::size_t t) {
            control_.check();
            base::SplitMix64 random(base::SplitMix64::mix(sample_.seed) + t);
            for (VectorXd& force : forces[t]) {
                const std::size_t pattern = sample_.patterns[random.below(sample_.patterns.size())];
                const SwapAnswer answer =
                    swap_answer(model_.tiles[t], stiffness_of(TileIndex(t), sample_.painting[t]),
                                stiffness_of(TileIndex(t), pattern));
                force = linear_.tiles[t].slopes.transpose() * (basis_of(TileIndex(t)) * answer.stress);
            }
        });
        MatrixXd all = MatrixXd::Zero(linear_.loads.size(), count + 1);
        base::SplitMix64 random(sample_.seed);
        for (Index c = 0; c < count; ++c) {
            for (std::size_t t = 0; t < forces.size(); ++t) {
                const double sign = random.below(2) == 0 ? 1.0 : -1.0;
                add_at_nodes(linear_.tiles[t], sign * forces[t][random.below(kSwapsOfATile)], all.col(c));
            }
        }
        all.col(count).head(state_.unit_loads.size()) =
            Eigen::Map<const VectorXd>(state_.unit_loads.data(), state_.unit_loads.size());
        return all;
    }

    /// One solution for each strain of each tile.
    void take_flexibility() {
        Index size = 0;
        for (const CaseModel::Tile& tile : model_.tiles) {
            model_.first.push_back(size);
            size += tile.strains.size();
        }
        MatrixXd forces = MatrixXd::Zero(linear_.loads.size(), size);
        for (const TileIndex tile : model_.tiles.indices()) {
            const MatrixXd own = linear_.tiles[tile].slopes.transpose() * basis_of(tile);
            for (Index c = 0; c < own.cols(); ++c)
                add_at_nodes(linear_.tiles[tile], own.col(c), forces.col(model_.first[tile] + c));
        }
        const MatrixXd motions = linear_.tangent.motions(forces, control_);
        MatrixXd all(size, size);
        for (const TileIndex tile : model_.tiles.indices())
            all.middleRows(model_.first[tile], model_.tiles[tile].strains.size()) =
                basis_of(tile).transpose() *
                (linear_.tiles[tile].slopes * at_nodes(linear_.tiles[tile], motions));
        model_.flexibility = 0.5 * (all + all.transpose());
    }

    /// A column for each prescribed entry: one at its dofs, zero elsewhere.
    [[nodiscard]] MatrixXd prescribed_units() const {
        const auto& entries = state_.session.load_case().prescribed;
        MatrixXd units = MatrixXd::Zero(linear_.loads.size(), std::ssize(entries));
        for (std::size_t e = 0; e < entries.size(); ++e) {
            for (const auto node :
                 simulation::select_nodes(entries[e].where, state_.session.surface().tessellation))
                units(kDofs * node.value + static_cast<Index>(entries[e].dof), static_cast<Index>(e)) = 1.0;
        }
        return units;
    }

    /// Orthonormal combinations of the residuals; the identity if there are few residuals.
    MatrixXd choose_basis() {
        const Index all = std::ssize(observations_);
        if (all <= sample_.directions) return MatrixXd::Identity(all, all);
        MatrixXd motions = linear_.tangent.motions(random_swaps(sample_.directions - 2), control_);
        const MatrixXd units = prescribed_units();
        if (units.cols() > 0) {
            const Index before = motions.cols();
            motions.conservativeResize(Eigen::NoChange, before + units.cols());
            motions.rightCols(units.cols()) = linear_.tangent.motions_of_held(units, control_);
        }
        // With the residuals among the columns, all first derivatives of the misfit are exact.
        MatrixXd answers(all, motions.cols() + 1);
        answers.leftCols(motions.cols()) =
            observed(observations_, state_.scale, linear_.tangent.as_rotation_vectors(motions));
        answers.rightCols(1) = weighted_residuals();
        for (auto column : answers.colwise()) column /= std::max(column.norm(), 1e-300);
        Eigen::ColPivHouseholderQR<MatrixXd> factors(answers);
        factors.setThreshold(kSmallDirection);
        const MatrixXd leading = MatrixXd::Identity(all, std::max<Index>(1, factors.rank()));
        return factors.householderQ() * leading;
    }

    [[nodiscard]] VectorXd weighted_residuals() const {
        VectorXd residuals(std::ssize(observations_));
        for (Index i = 0; i < residuals.size(); ++i) {
            const Observation& own = observations_[static_cast<std::size_t>(i)];
            residuals[i] = state_.scale * std::sqrt(own.weight) * own.residual;
        }
        return residuals;
    }

    void take_reach(const MatrixXd& adjoint) {
        base::parallel_for(model_.tiles.size(), sample_.threads, [&](std::size_t t) {
            control_.check();
            const MatrixXd own = at_nodes(linear_.tiles[t], adjoint);
            model_.tiles[t].reach =
                (basis_of(TileIndex(t)).transpose() * (linear_.tiles[t].slopes * own)).transpose();
            model_.tiles[t].of_weight.setZero(adjoint.cols());
            const Index nodes = std::ssize(linear_.tiles[t].nodes);
            for (Index i = 0; i < nodes; ++i)
                model_.tiles[t].of_weight +=
                    own.middleRows<3>(kDofs * i).transpose() * linear_.gravity / static_cast<double>(nodes);
        });
    }

    void take_prescribed(const MatrixXd& gradients, const MatrixXd& adjoint) {
        const MatrixXd units = prescribed_units();
        model_.by_prescribed.setZero(adjoint.cols(), units.cols());
        if (units.cols() > 0)
            model_.by_prescribed = linear_.tangent.by_held_values(gradients, adjoint).transpose() * units;
    }

    const CaseState& state_;
    const SwapSample& sample_;
    const base::Control& control_;
    Linearization linear_;
    std::vector<Observation> observations_;
    CaseModel model_;
};

}  // namespace

SwapAnswer swap_answer(const CaseModel::Tile& tile, const TileStrains::Blocks& from,
                       const TileStrains::Blocks& to) {
    const Index half = from.in_plane.rows();
    const MatrixXd in_plane = to.in_plane - from.in_plane;
    const MatrixXd out_of_plane = to.out_of_plane - from.out_of_plane;
    MatrixXd matrix(2 * half, 2 * half);
    matrix.topRows(half).noalias() = in_plane * tile.flexibility.topRows(half);
    matrix.bottomRows(half).noalias() = out_of_plane * tile.flexibility.bottomRows(half);
    matrix.diagonal().array() += 1.0;
    VectorXd right(2 * half);
    right << -(in_plane * tile.strains.head(half)), -(out_of_plane * tile.strains.tail(half));
    SwapAnswer answer{Eigen::PartialPivLU<Eigen::Ref<MatrixXd>>(matrix).solve(right), 0.0};
    answer.energy = answer.stress.dot(tile.flexibility * answer.stress);
    return answer;
}

CaseModel linearize_case(const CaseState& state, const SwapSample& sample, const base::Control& control) {
    return CaseLinearizer(state, sample, control).model();
}

}  // namespace fretwork::design::detail
