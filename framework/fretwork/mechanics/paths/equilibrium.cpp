// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/nonlinear/lowest_mode.hpp>
#include <fretwork/mechanics/nonlinear/newton.hpp>
#include <fretwork/mechanics/nonlinear/path_predictor.hpp>
#include <fretwork/mechanics/nonlinear/stride.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fretwork::mechanics {
namespace {

using nonlinear::Configuration;
using nonlinear::PathPoint;

/// Near a limit load the path turns back, and the response to load grows without bound; by the time that
/// steps have been halved ten times it has grown thirtyfold. Elsewhere a step that fails is divergence.
constexpr double kLimitLoadGrowth = 8.0;

/// On one path a move is about the step times the mean of the rates at its ends. An equilibrium that differs
/// from that by more than this share, in any component (those that move less than the second of these shares
/// of the largest count as that), is on another branch, or too far to decide: the step is halved. The
/// shortest steps end beside limit loads, where rates grow without bound: there it may lie this many times
/// farther than the rates account for. Moves as small as the last of these (in rad and element lengths) are
/// linear.
constexpr double kUnexplained = 0.3;
constexpr double kOwnMove = 0.3;
constexpr double kJump = 3.0;
constexpr double kSmallMove = 1e-6;

/// Where stability changes, limit loads are near, and a long step may land beyond them: it is halved until it
/// is at most this share of the load.
constexpr double kLongestCrossing = 1.0 / 64.0;

/// How far the push goes from an unstable equilibrium (rad, or element lengths).
constexpr double kPush = 0.02;

/// A branch whose lowest eigenvalue is below this share of the one that was lost is taken to be neutral: else
/// it is about twice as large.
constexpr double kNeutral = 0.5;

/// rad: a path goes to its next load in one stride if the guess turns a node by more than this; below,
/// Newton's method needs a step or two from the guess.
constexpr double kStride = 0.3;
/// rad: a step turns no node by more than this if it is prescribed how far.
constexpr double kPrescribedTurn = 0.7;

/// Above the last load of a path by this share of the load that is aimed at, no equilibrium is left nearby.
constexpr double kBeyondLimit = 1e-3;

/// Critical loads are found to this relative accuracy, with at most this many equilibria.
constexpr double kCriticalWidth = 1e-6;
constexpr int kCriticalSteps = 30;

constexpr std::size_t kThousand = 1000;  // steps of the reported task

class LoadPath {
  public:
    LoadPath(const Assembly& assembly, const EquilibriumOptions& options)
        : options_(options),
          system_(assembly, options.threads, options.control),
          newton_(system_, options),
          mixed_(system_, newton_, options),
          point_{unknowns_.rest(), 0.0, {}, {}, 0.0},
          predictor_(unknowns_) {
        mixed_.begin_at_rest(point_.configuration);
        point_.rate = newton_.solve_tangent(system_.load_rate());
        rest_rate_ = unknowns_.largest_component(point_.rate);
        predictor_.add(0.0, point_.configuration, point_.rate);
        prescribed_turn_ = unknowns_.largest_prescribed_rotation();
    }

    /// @param task  receives the share of the last load factor, in thousandths
    Solution advance_to(double target, const base::Task& task, double last) {
        const bool strides = may_stride(target);
        if (strides && stride_to(target) == Termination::Converged) {
            report(task, last);
            return solution(Termination::Converged);
        }
        double step = target - point_.load_factor;
        if (prescribed_turn_ > 0.0) step = std::min(step, kPrescribedTurn / prescribed_turn_);
        shortest_step_ = step / std::pow(2.0, options_.largest_cut_back);
        longest_crossing_ = std::max(kLongestCrossing * target, 2.0 * shortest_step_);
        Termination termination = Termination::Converged;
        while (point_.load_factor < target && termination == Termination::Converged) {
            const bool reaches = point_.load_factor + step >= target - 0.5 * shortest_step_;
            termination = try_step(reaches ? target : point_.load_factor + step);
            report(task, last);
            if (termination != Termination::Converged && newton_.has_neutral())
                termination = try_soft_step(reaches ? target : point_.load_factor + step);
            if (termination != Termination::Converged && step > 1.5 * shortest_step_) {
                step *= 0.5;
                termination = Termination::Converged;
            } else if (options_.branch == Branch::Snapping && is_limit(termination)) {
                step = std::max(step, kBeyondLimit * target);
                termination = snap_to(std::min(point_.load_factor + step, target));
                step = target - point_.load_factor;
            }
        }
        return solution(termination);
    }

  private:
    void report(const base::Task& task, double last) const {
        task.update(static_cast<std::size_t>(static_cast<double>(kThousand) * point_.load_factor / last));
    }

    /// Where only the equilibria at the loads count, not where stability is lost on the way to them.
    [[nodiscard]] bool may_stride(double target) const {
        if (options_.branch != Branch::Primary || options_.locate_critical_loads) return false;
        if (!point_.outcome.positive_definite()) return false;
        return is_at_rest_ || unknowns_.largest_rotation(predictor_.step_to(target)) > kStride;
    }

    Termination stride_to(double target) {
        if (!mixed_is_here_ && !mixed_.begin(point_.configuration, point_.load_factor))
            return Termination::Diverged;
        const Termination found = nonlinear::stride(system_, newton_, mixed_, point_, target);
        mixed_is_here_ = found == Termination::Converged;
        if (!mixed_is_here_) return found;
        is_at_rest_ = false;
        predictor_.add(point_.load_factor, point_.configuration, point_.rate);
        return found;
    }

    /// Whether a path that ends so ends in a limit load.
    [[nodiscard]] bool is_limit(Termination termination) const {
        if (termination == Termination::Converged) return false;
        return termination == Termination::LimitLoad ||
               unknowns_.largest_component(point_.rate) > kLimitLoadGrowth * rest_rate_;
    }

    /// Where the path ends in a limit load: on to the stable equilibrium downhill, at this load.
    Termination snap_to(double factor) {
        Configuration snapped = point_.configuration;
        unknowns_.prescribe(factor, snapped);
        newton_.set_neutral({}, 0.0);
        const Termination found = nonlinear::descend(factor, system_, newton_, snapped);
        if (found != Termination::Converged) return Termination::LimitLoad;
        unknowns_.unwind(point_.configuration, snapped);
        nonlinear::LowestMode jump{0.0, unknowns_.step_between(point_.configuration, snapped)};
        StabilityLoss loss = nonlinear::describe_loss(system_, jump);
        loss.load_factor = point_.load_factor;
        loss.pushed = true;
        losses_.push_back(loss);
        continue_from(std::move(snapped), factor);
        return Termination::Converged;
    }

    /// A stable equilibrium that no short step has led to.
    void continue_from(Configuration configuration, double factor) {
        point_.configuration = std::move(configuration);
        point_.load_factor = factor;
        point_.outcome = {};
        point_.turn_bound = std::numbers::pi;  // unknown
        mixed_is_here_ = is_at_rest_ = false;
        system_.evaluate(point_.configuration, factor);
        predict_anew();
    }

    /// A motion that was taken to be neutral may only be soft.
    Termination try_soft_step(double factor) {
        const Eigen::VectorXd neutral = newton_.neutral();
        newton_.set_neutral({}, 0.0);
        const Termination termination = try_step(factor);
        if (termination != Termination::Converged)
            newton_.set_neutral(neutral, nonlinear::rounding_shift(system_));
        return termination;
    }

    Termination try_step(double factor) {
        Configuration trial = point_.configuration;
        const Eigen::VectorXd guess = predictor_.step_to(factor);
        unknowns_.prescribe(factor, trial);
        unknowns_.move(capped(guess), trial);
        const Termination termination = newton_.solve(factor, trial);
        if (termination != Termination::Converged) return termination;
        unknowns_.unwind(point_.configuration, trial);
        const Eigen::VectorXd move = unknowns_.step_between(point_.configuration, trial);
        const double turn_bound = turn_bound_at(factor, move, trial);
        if (turn_bound > std::numbers::pi) return Termination::Diverged;
        const auto outcome = newton_.factorize();
        const bool crosses = outcome.negative_pivots != point_.outcome.negative_pivots;
        if (crosses && factor - point_.load_factor > longest_crossing_) return Termination::LimitLoad;
        Eigen::VectorXd rate = outcome.zero_pivot < 0 ? newton_.solve_tangent(system_.load_rate())
                                                      : Eigen::VectorXd(move / (factor - point_.load_factor));
        if (is_jump(factor - point_.load_factor, move, rate)) return Termination::LimitLoad;
        const bool loses_stability = point_.outcome.positive_definite() && !outcome.positive_definite();
        if (loses_stability && (options_.locate_critical_loads || options_.branch != Branch::Primary)) {
            const Termination left = leave(factor, move, trial);
            if (left != Termination::Converged) return left;
            if (options_.branch != Branch::Primary) return Termination::Converged;
        }
        point_ = {std::move(trial), factor, std::move(rate), outcome, turn_bound};
        mixed_is_here_ = is_at_rest_ = false;
        if (newton_.has_neutral()) {
            newton_.set_neutral(lowest_mode_here().shape, nonlinear::rounding_shift(system_));
            predict_anew();
        } else {
            predictor_.add(point_.load_factor, point_.configuration, point_.rate);
        }
        return Termination::Converged;
    }

    [[nodiscard]] double turn_bound_at(double factor, const Eigen::VectorXd& move,
                                       const Configuration& trial) const {
        const double turned =
            std::max(unknowns_.largest_rotation(move), (factor - point_.load_factor) * prescribed_turn_);
        return nonlinear::bound_relative_turn(system_, point_, turned, trial);
    }

    /// The push has left the path next to a circle of equilibria if it resists one direction much less than
    /// the unstable one resisted before: a symmetry turns the buckled shape about an axis.
    void begin_branch(double unstable_eigenvalue) {
        newton_.set_neutral({}, 0.0);
        const nonlinear::LowestMode mode = lowest_mode_here();
        if (mode.eigenvalue < kNeutral * std::abs(unstable_eigenvalue))
            newton_.set_neutral(mode.shape, nonlinear::rounding_shift(system_));
        predict_anew();
    }

    /// Stability of the last equilibrium, at which the system is evaluated.
    nonlinear::LowestMode lowest_mode_here() {
        system_.evaluate(point_.configuration, point_.load_factor);
        return nonlinear::lowest_mode(system_, newton_);
    }

    /// Each step has its own neutral direction; moves and rates are measured against it. The system is
    /// evaluated at the last equilibrium.
    void predict_anew() {
        (void)newton_.factorize();
        point_.rate = newton_.solve_tangent(system_.load_rate());
        predictor_.restart();
        predictor_.add(point_.load_factor, point_.configuration, point_.rate);
    }

    /// The path has become unstable on the way to `unstable`: find where, and go on along a stable branch if
    /// that is wished.
    Termination leave(double factor, const Eigen::VectorXd& move, Configuration& unstable) {
        system_.evaluate(unstable, factor);
        nonlinear::LowestMode mode = nonlinear::lowest_mode(system_, newton_);
        StabilityLoss loss = nonlinear::describe_loss(system_, mode);
        loss.load_factor = critical_factor({factor, mode.eigenvalue}, move);
        if (options_.branch != Branch::Primary) {
            Configuration pushed = unstable;
            unknowns_.move(kPush * mode.shape / unknowns_.largest_component(mode.shape), pushed);
            const Termination found = nonlinear::descend(factor, system_, newton_, pushed);
            if (found != Termination::Converged) return found;
            loss.pushed = true;
            unknowns_.unwind(point_.configuration, pushed);
            point_.configuration = std::move(pushed);
            point_.load_factor = factor;
            point_.outcome = {};
            point_.turn_bound = std::numbers::pi;  // unknown
            begin_branch(mode.eigenvalue);
        } else {
            system_.evaluate(unstable, factor);
        }
        losses_.push_back(loss);
        return Termination::Converged;
    }

    struct Lowest {
        double factor;
        double eigenvalue;
    };

    /// Where the lowest eigenvalue vanishes between the last equilibrium and an unstable one: the false
    /// position, halving the weight of an end that stays (the Illinois rule).
    [[nodiscard]] double critical_factor(Lowest unstable, const Eigen::VectorXd& move) {
        const double span = unstable.factor - point_.load_factor;
        Lowest stable{point_.load_factor, lowest_mode_here().eigenvalue};
        int side = 0;
        for (int i = 0;
             i < kCriticalSteps && unstable.factor - stable.factor > kCriticalWidth * unstable.factor; ++i) {
            const double share = stable.eigenvalue / (stable.eigenvalue - unstable.eigenvalue);
            const double factor = stable.factor + share * (unstable.factor - stable.factor);
            Configuration trial = point_.configuration;
            unknowns_.prescribe(factor, trial);
            unknowns_.move(((factor - point_.load_factor) / span) * move, trial);
            if (newton_.solve(factor, trial) != Termination::Converged) break;
            const Lowest found{factor, nonlinear::lowest_mode(system_, newton_).eigenvalue};
            const bool is_stable = found.eigenvalue > 0.0;
            if (side == (is_stable ? 1 : -1)) (is_stable ? unstable : stable).eigenvalue *= 0.5;
            side = is_stable ? 1 : -1;
            (is_stable ? stable : unstable) = found;
        }
        const double share = stable.eigenvalue / (stable.eigenvalue - unstable.eigenvalue);
        return stable.factor + std::clamp(share, 0.0, 1.0) * (unstable.factor - stable.factor);
    }

    /// Newton's method may find an equilibrium on a far branch, to which the structure would snap.
    [[nodiscard]] bool is_jump(double step, const Eigen::VectorXd& move, const Eigen::VectorXd& rate) const {
        const double moved = unknowns_.largest_component(move);
        if (moved <= kSmallMove) return false;
        if (step < 1.5 * shortest_step_) {
            const double rates = unknowns_.largest_component(point_.rate) * unknowns_.largest_component(rate);
            return moved > kJump * step * std::sqrt(rates);
        }
        const Eigen::ArrayXd unit = unknowns_.weights().array().sqrt();
        const Eigen::ArrayXd explained = 0.5 * step * unit * (point_.rate + rate).array();
        const Eigen::ArrayXd made = unit * move.array();
        const Eigen::ArrayXd own = explained.abs().max(made.abs());
        return ((made - explained).abs() > kUnexplained * own.max(kOwnMove * own.maxCoeff())).any();
    }

    [[nodiscard]] Eigen::VectorXd capped(const Eigen::VectorXd& guess) const {
        const double rotation = unknowns_.largest_rotation(guess);
        return guess * std::min(1.0, options_.largest_rotation_step / std::max(rotation, 1e-300));
    }

    [[nodiscard]] Solution solution(Termination termination) {
        if (termination != Termination::Converged) {
            if (is_limit(termination)) termination = Termination::LimitLoad;
            system_.evaluate(point_.configuration, point_.load_factor);
        }
        Solution solution = system_.describe(point_.configuration, point_.load_factor);
        solution.termination = termination;
        if (options_.classify_stability) {
            solution.stable = point_.outcome.positive_definite();
            solution.stability = system_.stability_test();
        }
        solution.iterations = newton_.take_iterations();
        solution.stability_losses = std::exchange(losses_, {});
        return solution;
    }

    const EquilibriumOptions& options_;
    nonlinear::NonlinearSystem system_;
    const nonlinear::Unknowns& unknowns_ = system_.unknowns();
    nonlinear::Newton newton_;
    nonlinear::MixedNewton mixed_;
    PathPoint point_;  ///< the last equilibrium
    bool is_at_rest_ = true;
    bool mixed_is_here_ = true;  ///< its stresses and factors are those of the last equilibrium
    double shortest_step_ = 0.0;
    double longest_crossing_ = 0.0;  ///< of steps on which stability changes
    double rest_rate_ = 0.0;
    double prescribed_turn_ = 0.0;  ///< the largest rotation that is prescribed at a node, at the full load
    nonlinear::PathPredictor predictor_;
    std::vector<StabilityLoss> losses_;
};

void check_factors(std::span<const double> factors) {
    double last = 0.0;
    for (const double factor : factors) {
        if (!std::isfinite(factor) || !(factor > last))
            throw base::InputError("load factor " + base::format_number(factor) +
                                   " does not lie above the one before it, " + base::format_number(last));
        last = factor;
    }
}

}  // namespace

std::vector<Solution> follow_load_path(const Assembly& assembly, std::span<const double> load_factors,
                                       const EquilibriumOptions& options) {
    options.validate();
    check_factors(load_factors);
    std::vector<Solution> solutions;
    if (load_factors.empty()) return solutions;
    LoadPath path(assembly, options);
    const base::Task task(options.control, "load path (thousandths of the load)", kThousand);
    for (const double factor : load_factors) {
        if (solutions.empty() || solutions.back().converged()) {
            solutions.push_back(path.advance_to(factor, task, load_factors.back()));
        } else {
            solutions.push_back(solutions.back());
            solutions.back().iterations = 0;
            solutions.back().stability_losses.clear();  // reported once
        }
    }
    return solutions;
}

}  // namespace fretwork::mechanics
