// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/nonlinear/stride.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::mechanics::nonlinear {
namespace {

/// The largest rotation of a node, rad, in the first step of an increment, and the largest increment of a
/// prescribed rotation. Steps of a radian converge as well, but often pass tangents that are not positive
/// definite, and are then repeated with half the length.
constexpr double kLongestTurn = 0.4;
constexpr double kPrescribedTurn = 0.7;
/// The factor by which first steps grow after each successful increment; after a failed increment, they are
/// halved.
constexpr double kRecovery = 1.4;
/// The largest rotation of a node in a whole increment, rad.
constexpr double kWholeTurn = 2.5;
constexpr int kMostHalvings = 6;
/// The largest ratio of an increment to the previous increment, and the further factor allowed if the
/// increment is then the last.
constexpr double kGrowth = 4.0;
constexpr double kRemainder = 1.3;

/// The largest move of a component, as a multiple of the prediction by the larger rate at the increment's
/// ends, plus a share of the largest move.
constexpr double kExplained = 2.0;
constexpr double kOwnMove = 0.15;
/// The largest growth of rates over an increment.
constexpr double kSoftening = 2.0;

/// The bound on the relative rotation of an element's ends, rad, below which no element is evaluated.
constexpr double kSafeTurn = 2.5;

class Strider {
  public:
    Strider(NonlinearSystem& system, Newton& newton, MixedNewton& mixed, double target)
        : system_(system), unknowns_(system.unknowns()), newton_(newton), mixed_(mixed), target_(target) {
        prescribed_turn_ = unknowns_.largest_prescribed_rotation();
    }

    Termination run(PathPoint& point) {
        PathPoint at = point;
        correction_ = Eigen::VectorXd::Zero(unknowns_.equations());
        longest_ = target_ - at.load_factor;
        int halvings = 0;
        while (at.load_factor < target_) {
            const std::vector<double> stresses = mixed_.stresses();
            const Termination found = increment(at);
            if (found == Termination::Converged) {
                longest_turn_ = std::min(kLongestTurn, kRecovery * longest_turn_);
                continue;
            }
            if (++halvings > kMostHalvings) return found;
            longest_ *= 0.5;
            longest_turn_ *= 0.5;
            mixed_.go_back({at.configuration, at.load_factor, at.outcome}, stresses);
        }
        point = std::move(at);
        return Termination::Converged;
    }

  private:
    Termination increment(PathPoint& at) {
        const double turn = std::max(unknowns_.largest_rotation(at.rate),
                                     prescribed_turn_ * (kLongestTurn / kPrescribedTurn));
        const double left = longest_turn_ - unknowns_.largest_rotation(correction_);
        longest_ = std::min({longest_, target_ - at.load_factor,
                             std::max(left, 0.1 * longest_turn_) / std::max(turn, 1e-300)});
        const bool last = at.load_factor + kRemainder * longest_ >= target_;
        if (last) longest_ = target_ - at.load_factor;
        PathPoint next = at;
        next.load_factor = last ? target_ : at.load_factor + longest_;
        const Eigen::VectorXd step = correction_ + longest_ * at.rate;
        unknowns_.prescribe(next.load_factor, next.configuration);
        mixed_.move(step, longest_, next.configuration);
        const auto goal = last ? MixedNewton::Goal::Equilibrium : MixedNewton::Goal::Approach;
        const Termination found = mixed_.solve(next.load_factor, goal, step, next.configuration);
        if (found != Termination::Converged) return found;
        unknowns_.unwind(at.configuration, next.configuration);
        next.outcome = mixed_.outcome();
        next.rate = newton_.solve_tangent(system_.load_rate());
        const Eigen::VectorXd move = unknowns_.step_between(at.configuration, next.configuration);
        const double turned = std::max(unknowns_.largest_rotation(move), longest_ * prescribed_turn_);
        next.turn_bound = bound_relative_turn(system_, at, turned, next.configuration);
        if (turned > kWholeTurn || next.turn_bound > std::numbers::pi) return Termination::Diverged;
        if (is_softened(unknowns_, at.rate, next.rate)) return Termination::LimitLoad;
        const Eigen::VectorXd rates = longest_ * at.rate.cwiseAbs().cwiseMax(next.rate.cwiseAbs());
        if (is_jump(unknowns_, (move - correction_).cwiseAbs() - correction_.cwiseAbs(), rates))
            return Termination::LimitLoad;
        if (!last) correction_ = newton_.solve_tangent(system_.unbalanced());
        longest_ *= kGrowth;
        at = std::move(next);
        return Termination::Converged;
    }

    NonlinearSystem& system_;
    const Unknowns& unknowns_;
    Newton& newton_;
    MixedNewton& mixed_;
    double target_;
    double prescribed_turn_ = 0.0;        ///< largest prescribed rotation of a node on the whole path, rad
    double longest_ = 0.0;                ///< largest increment of the load factor
    double longest_turn_ = kLongestTurn;  ///< largest rotation in an increment's first step, rad
    Eigen::VectorXd correction_;          ///< correction left by the last approach
};

}  // namespace

double bound_relative_turn(const NonlinearSystem& system, const PathPoint& from, double turned,
                           const Configuration& to) {
    const double bound = from.turn_bound + 2.0 * turned;
    if (bound < kSafeTurn) return bound;
    const auto turn = system.relative_turn(to, from.configuration);
    return turn.largest_change > 0.5 * std::numbers::pi ? 2.0 * std::numbers::pi : turn.largest;
}

double bound_relative_turn(const NonlinearSystem& system, const PathPoint& from, const Eigen::VectorXd& move,
                           double load_factor, const Configuration& to) {
    const Unknowns& unknowns = system.unknowns();
    const double prescribed =
        std::abs(load_factor - from.load_factor) * unknowns.largest_prescribed_rotation();
    return bound_relative_turn(system, from, std::max(unknowns.largest_rotation(move), prescribed), to);
}

bool is_jump(const Unknowns& unknowns, const Eigen::VectorXd& made, const Eigen::VectorXd& rates) {
    const Eigen::ArrayXd unit = unknowns.weights().array().sqrt();
    const Eigen::ArrayXd moved = unit * made.array();
    const double largest = moved.size() > 0 ? moved.maxCoeff() : 0.0;
    if (largest <= kLinearMove) return false;
    return (moved > kExplained * unit * rates.array() + kOwnMove * largest).any();
}

bool is_softened(const Unknowns& unknowns, const Eigen::VectorXd& first_rate,
                 const Eigen::VectorXd& last_rate) {
    return unknowns.largest_component(last_rate) > kSoftening * unknowns.largest_component(first_rate);
}

Termination stride(NonlinearSystem& system, Newton& newton, MixedNewton& mixed, PathPoint& point,
                   double target) {
    return Strider(system, newton, mixed, target).run(point);
}

}  // namespace fretwork::mechanics::nonlinear
