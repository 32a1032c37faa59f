// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/design/swaps/relaxed_choice.hpp>

#include <algorithm>

namespace fretwork::design::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostMixingPasses = 400;
/// Passes end at a gap of kSmallMixingGap times the objective, or kNothingLeft times that of the start.
constexpr double kSmallMixingGap = 1e-2;
constexpr double kNothingLeft = 1e-9;
/// Steps of one group in one pass.
constexpr int kMixingSteps = 4;

class Relaxation {
  public:
    Relaxation(const SwapTable& table, const std::vector<std::size_t>& start) : basis_(unknown_basis(table)) {
        residual_ = left_by_unknowns(basis_, table.residual);
        for (std::size_t g = 0; g < start.size(); ++g) {
            responses_.push_back(left_by_unknowns(basis_, table.responses[g]));
            const auto own = static_cast<Index>(start[g]);
            weights_.push_back(VectorXd::Unit(responses_[g].cols(), own));
            residual_ += responses_[g].col(own);
        }
    }

    /// Moves weight from the worst column that has any to the best one.
    void improve(std::size_t group) {
        const MatrixXd& responses = responses_[group];
        VectorXd& weights = weights_[group];
        for (int step = 0; step < kMixingSteps; ++step) {
            const VectorXd slopes = responses.transpose() * residual_;
            Index best = 0;
            slopes.minCoeff(&best);
            Index worst = best;
            for (Index c = 0; c < slopes.size(); ++c) {
                if (weights[c] > 0.0 && slopes[c] > slopes[worst]) worst = c;
            }
            const VectorXd along = responses.col(best) - responses.col(worst);
            const double square = along.squaredNorm();
            if (!(square > 0.0)) return;
            const double moved = std::clamp(-residual_.dot(along) / square, 0.0, weights[worst]);
            weights[best] += moved;
            weights[worst] -= moved;
            residual_ += moved * along;
        }
    }

    /// The Frank-Wolfe gap. No mixture is better by more than this, because the objective is convex.
    [[nodiscard]] double gap() const {
        double sum = 0.0;
        for (std::size_t g = 0; g < weights_.size(); ++g) {
            const VectorXd slopes = responses_[g].transpose() * residual_;
            sum += 2.0 * (weights_[g].dot(slopes) - slopes.minCoeff());
        }
        return sum;
    }

    [[nodiscard]] double objective() const { return residual_.squaredNorm(); }
    [[nodiscard]] const std::vector<VectorXd>& weights() const { return weights_; }

  private:
    MatrixXd basis_;
    std::vector<MatrixXd> responses_;
    std::vector<VectorXd> weights_;
    VectorXd residual_;
};

}  // namespace

RelaxedChoice relaxed_choice(const SwapTable& table, const std::vector<std::size_t>& start,
                             const base::Control& control) {
    Relaxation relaxation(table, start);
    const double first = relaxation.objective();
    RelaxedChoice choice;
    for (int pass = 0; pass < kMostMixingPasses; ++pass) {
        control.check();
        for (std::size_t g = 0; g < start.size(); ++g) relaxation.improve(g);
        choice.objective = table.unreached + relaxation.objective();
        choice.gap = relaxation.gap();
        if (choice.gap <= std::max(kSmallMixingGap * choice.objective, kNothingLeft * first)) break;
    }
    choice.weights = relaxation.weights();
    return choice;
}

}  // namespace fretwork::design::detail
