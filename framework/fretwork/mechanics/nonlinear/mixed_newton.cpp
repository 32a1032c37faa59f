// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/nonlinear/mixed_newton.hpp>

#include <cmath>

namespace fretwork::mechanics::nonlinear {
namespace {

constexpr int kMostMixedIterations = 30;

/// The size of a step, rad, at which an approach ends.
constexpr double kApproach = 0.2;
/// The size of a step, rad, after which old factors would not help.
constexpr double kLongStep = 0.5;
/// The ratio of two successive steps with old factors above which new factors are computed. An iteration with
/// old factors costs at most a fifth of an iteration with new factors.
constexpr double kShrink = 0.3;
/// The predicted number of further iterations with old factors above which new factors are computed, if the
/// caller needs no factors at the equilibrium.
constexpr double kManyIterations = 6.0;
/// The ratio of two successive steps above which the later step with old factors is not made at all.
constexpr double kUseless = 0.5;
/// The size of a step, rad, below which the factors that are needed at the equilibrium anyway are computed.
/// With them, the iteration ends in a step or two.
constexpr double kNear = 3e-4;
/// The distance, in rad and as a share of all moves, within which factors count as the factors of the
/// equilibrium. Both are small, because a load that hardly moves a column may change its stability.
constexpr double kSame = 2e-4;
constexpr double kSameShare = 1e-3;
/// The size of a step, rad, that counts as divergence.
constexpr double kTooFar = 3.0;

}  // namespace

void MixedNewton::begin_at_rest(const Configuration& rest) {
    stresses_.give(std::vector<double>(stresses_.given().size(), 0.0));
    system_.evaluate_mixed(rest, 0.0, Demand::Tangent, stresses_);
    newton_.factorize_at_rest();
    outcome_ = {};
    way_ = {};
    has_foreign_factors_ = false;
}

void MixedNewton::give_own_stresses(const Configuration& configuration, double load_factor) {
    system_.evaluate_mixed(configuration, load_factor, Demand::Force, stresses_);
    stresses_.give_own();
}

bool MixedNewton::begin(const Configuration& equilibrium, double load_factor) {
    give_own_stresses(equilibrium, load_factor);
    return factorize(equilibrium, load_factor);
}

bool MixedNewton::come_back(const Configuration& equilibrium) {
    if (!way_at_departure_) return false;
    give_own_stresses(equilibrium, 1.0);
    way_ = *way_at_departure_;
    return true;
}

void MixedNewton::go_back(const Place& place, const std::vector<double>& stresses) {
    stresses_.give(stresses);
    system_.evaluate_mixed(place.configuration, place.load_factor, Demand::Tangent, stresses_);
    outcome_ = place.outcome;
    has_foreign_factors_ = true;
    way_at_departure_.reset();
}

/// Evaluate and factorize the tangent. False, without factors, if the residual is not finite or the tangent
/// is singular.
bool MixedNewton::factorize(const Configuration& configuration, double load_factor) {
    way_at_departure_.reset();
    has_foreign_factors_ = false;
    system_.evaluate_mixed(configuration, load_factor, Demand::Tangent, stresses_);
    if (!std::isfinite(system_.relative_residual())) return false;
    outcome_ = newton_.factorize();
    way_ = {};
    return outcome_.zero_pivot < 0;
}

/// True if iterations with old factors, whose steps shrink by this ratio, converge so slowly that new factors
/// pay off.
bool MixedNewton::is_slow(double ratio) const {
    if (options_.classify_stability) return false;
    const double digits = std::log(options_.relative_residual / system_.relative_residual());
    return digits < kManyIterations * std::log(ratio);
}

void MixedNewton::move(const Eigen::VectorXd& step, double prescribed, Configuration& configuration) {
    NodeValues motions = prescribed * unknowns_.prescribed_change();
    unknowns_.layout().scatter(step, motions);
    system_.extrapolate(motions, stresses_);
    unknowns_.move(step, configuration);
    way_.turned += unknowns_.largest_rotation(step);
    way_.moved += unknowns_.size_of(step);
}

/// Make the first step. Prescribed components move together with the unknowns, because alone they would fold
/// the elements next to them.
MixedNewton::FirstStep MixedNewton::depart(Configuration& configuration) {
    way_at_departure_ = way_;
    Configuration next = configuration;
    NodeValues motions = unknowns_.hold(next);
    const bool holds_move = !motions.isZero(0.0);
    system_.evaluate_mixed(configuration, 1.0, Demand::Force, stresses_);
    if (!holds_move && newton_.is_converged(configuration, {})) return {};
    FirstStep first{system_.mixed_unbalanced(), {}};
    if (holds_move) {
        system_.extrapolate(motions, stresses_);
        system_.evaluate_mixed(configuration, 1.0, Demand::Force, stresses_);
        first.unbalanced = system_.mixed_unbalanced() + system_.lag();
    }
    first.step = newton_.solve_tangent(first.unbalanced);
    unknowns_.layout().scatter(first.step, motions);
    system_.extrapolate(motions, stresses_);
    way_.turned += motions.rightCols<3>().rowwise().norm().maxCoeff();
    way_.moved += unknowns_.size_of(first.step);
    if (!(unknowns_.largest_rotation(first.step) <= kTooFar)) return first;
    unknowns_.move(first.step, next);
    configuration = std::move(next);
    return first;
}

/// True if the factors belong to the configuration, up to a negligible move.
bool MixedNewton::has_own_factors(const Iteration& iteration) const {
    return way_.turned <= kSame && way_.moved <= kSameShare * iteration.travelled;
}

/// True if the factors that are needed at the end anyway should be computed now.
bool MixedNewton::wants_own_factors(const Iteration& iteration) const {
    const bool is_approach = iteration.goal == Goal::Approach;
    if (!is_approach && !options_.classify_stability) return false;
    return iteration.turn <= (is_approach ? kApproach : kNear) && !has_own_factors(iteration);
}

/// Find the next step with new factors. Returns a termination if the iteration ends.
std::optional<Termination> MixedNewton::step_with_new_factors(Iteration& iteration,
                                                              const Configuration& configuration) {
    if (!factorize(configuration, iteration.load_factor)) return Termination::Diverged;
    if (outcome_.negative_pivots != iteration.negative_pivots) return Termination::LimitLoad;
    const bool ends = iteration.goal == Goal::Equilibrium
                          ? newton_.is_converged(configuration, iteration.step)
                          : iteration.turn <= kApproach;
    if (ends) return Termination::Converged;
    iteration.step = newton_.solve_tangent(system_.unbalanced());
    return std::nullopt;
}

/// Find the next step with old factors. Returns a termination if the iteration ends.
std::optional<Termination> MixedNewton::step_with_old_factors(Iteration& iteration,
                                                              const Configuration& configuration) {
    system_.evaluate_mixed(configuration, iteration.load_factor, Demand::Force, stresses_);
    if (!std::isfinite(system_.relative_residual())) return Termination::Diverged;
    if (iteration.goal == Goal::Equilibrium && newton_.is_converged(configuration, iteration.step))
        return end_at_equilibrium(iteration, configuration);
    iteration.step = newton_.solve_tangent(system_.mixed_unbalanced());
    return std::nullopt;
}

/// End at an equilibrium, and compute factors that decide its stability if the caller asks for it.
Termination MixedNewton::end_at_equilibrium(const Iteration& iteration, const Configuration& configuration) {
    if (has_own_factors(iteration) || !options_.classify_stability) return Termination::Converged;
    stresses_.give_own();
    if (!factorize(configuration, iteration.load_factor)) return Termination::Diverged;
    return outcome_.negative_pivots == iteration.negative_pivots ? Termination::Converged
                                                                 : Termination::LimitLoad;
}

Termination MixedNewton::solve(double load_factor, Goal goal, const Eigen::VectorXd& first,
                               Configuration& configuration) {
    double size = unknowns_.size_of(first);
    Iteration iteration{goal,  load_factor, outcome_.negative_pivots,
                        first, size,        unknowns_.largest_rotation(first)};
    bool anew = has_foreign_factors_ || iteration.turn > kLongStep;
    for (int i = 0; i < kMostMixedIterations; ++i) {
        anew = anew || wants_own_factors(iteration);
        const auto ended = anew ? step_with_new_factors(iteration, configuration)
                                : step_with_old_factors(iteration, configuration);
        if (ended) return *ended;
        const double ratio = unknowns_.size_of(iteration.step) / size;
        iteration.turn = unknowns_.largest_rotation(iteration.step);
        const bool is_useless = !anew && !(ratio <= kUseless);
        anew = anew ? iteration.turn > kLongStep : !(ratio <= kShrink) || is_slow(ratio);
        if (is_useless) continue;
        if (!(iteration.turn < kTooFar)) return Termination::Diverged;
        size *= ratio;
        iteration.travelled += size;
        move(iteration.step, 0.0, configuration);
    }
    return Termination::IterationsSpent;
}

}  // namespace fretwork::mechanics::nonlinear
