// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/nonlinear/arc.hpp>
#include <fretwork/mechanics/nonlinear/load_path.hpp>
#include <fretwork/mechanics/nonlinear/lowest_mode.hpp>
#include <fretwork/mechanics/nonlinear/path_predictor.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace fretwork::mechanics::nonlinear {
namespace {

constexpr double kPush = 0.02;  // size of the push from an unstable equilibrium, rad or element lengths

/// The lowest eigenvalue of a branch counts as zero below this share of the absolute eigenvalue of the
/// unstable equilibrium that was left. On other branches, the lowest eigenvalue is about twice that value.
constexpr double kNeutral = 0.5;

/// The rotation of a node, rad, above which a path goes to its next load in strides or along its arc.
constexpr double kStride = 0.3;
constexpr int kMostSteps = 3000;  // largest number of steps along the path to one load

/// A load that exceeds a limit load by this share of it has no equilibrium nearby.
constexpr double kBeyondLimit = 1e-3;
/// The relative accuracy of limit loads, and the largest number of equilibria to find one.
constexpr double kLimitWidth = 1e-6;
constexpr int kLimitSteps = 30;

}  // namespace

class LoadPath::Impl {
  public:
    Impl(const Assembly& assembly, const EquilibriumOptions& options, const std::optional<PathStart>& start)
        : options_(options),
          system_(assembly, options.threads, options.control),
          newton_(system_, options),
          mixed_(system_, newton_, options),
          stepper_(system_, newton_, options),
          point_{
              start ? start->configuration : unknowns_.rest(), 0.0, {}, {}, start ? std::numbers::pi : 0.0},
          least_load_scale_(start ? 1.0 : 0.0),
          is_at_rest_(!start),
          mixed_is_here_(!start),
          predictor_(unknowns_) {
        if (start) {
            beginning_ = begin_at(*start);
        } else {
            mixed_.begin_at_rest(point_.configuration);
            point_.rate = newton_.solve_tangent(system_.load_rate());
            predictor_.add(0.0, point_.configuration, point_.rate);
        }
        first_rate_ = point_.rate;
    }

    Solution advance_to(double target, const PathProgress& progress) {
        Termination termination = beginning_;
        if (termination == Termination::Converged) {
            termination = jump_to(target);
            if (termination != Termination::Converged) termination = follow_arc(target, progress);
        }
        report(progress);
        return solution(termination);
    }

    [[nodiscard]] PathEnd end() const {
        return {point_.configuration, system_.loads_at(point_.load_factor), system_.held_forces()};
    }

  private:
    void report(const PathProgress& progress) const {
        const double share = point_.load_factor / progress.last_load_factor;
        progress.task.update(static_cast<std::size_t>(kThousandths * share));
    }

    /// Begin at an equilibrium, which released components may have made inexact or unstable.
    Termination begin_at(const PathStart& start) {
        system_.begin_at(start.configuration, start.loads + start.released);
        Configuration beginning = point_.configuration;
        const Termination found = newton_.solve(0.0, beginning);
        if (found != Termination::Converged) return found;
        unknowns_.unwind(point_.configuration, beginning);
        point_.configuration = beginning;
        point_.outcome = newton_.factorize();
        if (point_.outcome.zero_pivot >= 0) return Termination::Diverged;
        if (!point_.outcome.positive_definite() && options_.branch != Branch::Primary) {
            if (start.released.isZero(0.0)) return leave(0.0, {}, beginning);
            // Drop the forces of the released supports: as loads, they would push the structure on.
            system_.begin_at(start.configuration, start.loads);
            return snap_to(0.0);
        }
        restart_prediction();
        return Termination::Converged;
    }

    /// Go to the wanted load in strides or in one step, without following the arc between the loads.
    Termination jump_to(double target) {
        const Eigen::VectorXd guess = predictor_.step_to(target);
        const bool is_far = turn_of(guess, target) > kStride;
        if (may_stride() && (is_at_rest_ || is_far) && stride_to(target) == Termination::Converged)
            return Termination::Converged;
        return !is_far && step_to(target, guess) ? Termination::Converged : Termination::Diverged;
    }

    /// The largest rotation of a node on the way to the predicted equilibrium.
    [[nodiscard]] double turn_of(const Eigen::VectorXd& guess, double target) const {
        const double prescribed = unknowns_.largest_prescribed_rotation() * (target - point_.load_factor);
        return std::max(prescribed, unknowns_.largest_rotation(guess));
    }

    /// True if no losses of stability between the given loads are wanted, and none seems near.
    [[nodiscard]] bool may_stride() const {
        if (options_.branch != Branch::Primary || options_.locate_critical_loads) return false;
        return point_.outcome.positive_definite() && !is_softened(unknowns_, first_rate_, point_.rate);
    }

    Termination stride_to(double target) {
        if (!mixed_is_here_ && !mixed_.begin(point_.configuration, point_.load_factor))
            return Termination::Diverged;
        const Termination found = stride(system_, newton_, mixed_, point_, target);
        mixed_is_here_ = found == Termination::Converged;
        if (!mixed_is_here_) return found;
        is_at_rest_ = false;
        predictor_.add(point_.load_factor, point_.configuration, point_.rate);
        return found;
    }

    /// Go to the wanted load in one step, if the step continues the path without a limit load or a change of
    /// stability.
    bool step_to(double target, const Eigen::VectorXd& guess) {
        auto step = stepper_.step_to_load(stepper_.rising(point_), target, guess);
        if (!step && newton_.has_neutral()) {  // the neutral direction may only be soft
            const Eigen::VectorXd neutral = newton_.neutral();
            newton_.set_neutral({}, 0.0);
            step = stepper_.step_to_load(stepper_.rising(point_), target, guess);
            if (!step) newton_.set_neutral(neutral, rounding_shift(system_));
        }
        if (!step || step->state.load_rate < 0.0 || changes_stability(*step)) return false;
        go_to(std::move(step->state));
        return true;
    }

    [[nodiscard]] bool changes_stability(const PathStep& step) const {
        return step.state.point.outcome.negative_pivots != point_.outcome.negative_pivots;
    }

    /// Go to an equilibrium that continues the path.
    void go_to(PathState state) {
        point_ = std::move(state.point);
        mixed_is_here_ = is_at_rest_ = false;
        if (newton_.has_neutral()) {
            newton_.set_neutral(lowest_mode_here().shape, rounding_shift(system_));
            restart_prediction();
        } else {
            predictor_.add(point_.load_factor, point_.configuration, point_.rate);
        }
    }

    Arc arc_here(double target) { return begin_arc(stepper_, point_, target, least_load_scale_); }

    /// Follow the path step by step, in load and displacements together, until the wanted load is reached.
    Termination follow_arc(double target, const PathProgress& progress) {
        Arc arc = arc_here(target);
        for (int steps = 0; steps < kMostSteps; ++steps) {
            if (point_.load_factor >= target) return Termination::Converged;
            if (arc.length < arc.shortest) {
                if (!newton_.has_neutral()) return Termination::Diverged;
                newton_.set_neutral({}, 0.0);
                arc = arc_here(target);
            }
            auto step = stepper_.step(arc.state, arc.last(), arc.length);
            if (step && step->state.point.load_factor > target)
                step = stepper_.step_within(arc.state, *step, target);
            if (!step) {
                arc.length *= 0.5;
                continue;
            }
            const Termination taken = take(arc, std::move(*step), target);
            if (taken != Termination::Converged) return taken;
            report(progress);
        }
        return Termination::IterationsSpent;
    }

    /// Take a step. If the step passes a limit load or a change of stability, come nearer to it first.
    Termination take(Arc& arc, PathStep step, double target) {
        if (step.state.load_rate < 0.0) return pass_limit(arc, std::move(step), target);
        if (may_end_stability(step)) {
            return arc.come_nearer(step.length) ? Termination::Converged
                                                : pass_change(arc, std::move(step), target);
        }
        arc.plan_next(step);
        advance(arc, std::move(step.state));
        return Termination::Converged;
    }

    void advance(Arc& arc, PathState state) {
        go_to(state);
        if (newton_.has_neutral()) {
            arc.previous.reset();
            arc.state = stepper_.rising(point_);
        } else {
            arc.previous = std::exchange(arc.state, std::move(state));
        }
    }

    /// True if stability may be lost or gained for good on the step: it changes, and one end is stable.
    [[nodiscard]] bool may_end_stability(const PathStep& step) const {
        if (!changes_stability(step)) return false;
        return point_.outcome.positive_definite() || step.state.point.outcome.positive_definite();
    }

    /// Pass a change of stability: continue along the path, or leave it for a stable branch.
    Termination pass_change(Arc& arc, PathStep step, double target) {
        const bool is_loss = point_.outcome.positive_definite();
        if (!is_loss || (!options_.locate_critical_loads && options_.branch == Branch::Primary)) {
            arc.forget_crossing(step.length);
            advance(arc, std::move(step.state));
            return Termination::Converged;
        }
        const Termination left =
            leave(step.state.point.load_factor, step.move, step.state.point.configuration);
        if (left != Termination::Converged) {  // try again nearer to the change
            arc.length = 0.25 * step.length;
            return arc.is_narrow(arc.length) ? left : Termination::Converged;
        }
        arc.forget_crossing(step.length);
        if (options_.branch == Branch::Primary)
            advance(arc, std::move(step.state));
        else
            arc = arc_here(target);
        return Termination::Converged;
    }

    /// Go to the limit load, after a step at whose end the load falls; then snap, if the options ask for it.
    Termination pass_limit(Arc& arc, PathStep fallen, double target) {
        double rise = arc.state.load_rate;
        double span = fallen.length;
        for (int i = 0; i < kLimitSteps && rise * span > kLimitWidth * arc.load_scale(); ++i) {
            const double wanted = std::clamp(rise / (rise - fallen.state.load_rate), 0.1, 0.9) * span;
            auto step = stepper_.step(arc.state, arc.last(), wanted);
            if (!step) {
                arc.length = 0.5 * wanted;
                return Termination::Converged;
            }
            if (step->state.point.load_factor >= target) {
                arc.length = step->length;
                return Termination::Converged;
            }
            if (step->state.load_rate < 0.0) {
                span = step->length;
                fallen = std::move(*step);
                continue;
            }
            // Stability may be lost before the load reaches its limit.
            if (may_end_stability(*step)) return take(arc, std::move(*step), target);
            span -= step->length;
            rise = step->state.load_rate;
            arc.plan_next(*step);
            advance(arc, std::move(step->state));
        }
        return end_at_limit(arc, target);
    }

    Termination end_at_limit(Arc& arc, double target) {
        if (options_.branch == Branch::Snapping) {
            const Termination snapped =
                snap_to(std::min(point_.load_factor + kBeyondLimit * arc.load_scale(), target));
            if (snapped == Termination::Converged) arc = arc_here(target);
            return snapped;
        }
        LowestMode mode = lowest_mode_here();
        losses_.push_back(describe_loss(system_, mode, point_.load_factor));
        return Termination::LimitLoad;
    }

    /// Descend in energy from the last equilibrium (a limit load, or an unstable beginning) to a stable
    /// equilibrium at this load factor.
    Termination snap_to(double factor) {
        Configuration snapped = point_.configuration;
        unknowns_.prescribe(factor, snapped);
        newton_.set_neutral({}, 0.0);
        const Termination found = descend(factor, system_, newton_, snapped);
        if (found != Termination::Converged) return Termination::LimitLoad;
        unknowns_.unwind(point_.configuration, snapped);
        LowestMode jump{0.0, unknowns_.step_between(point_.configuration, snapped)};
        if (unknowns_.largest_component(jump.shape) > kLinearMove) {  // else the equilibrium was neutral
            losses_.push_back(describe_loss(system_, jump, point_.load_factor));
            losses_.back().pushed = true;
        }
        continue_from(std::move(snapped), factor);
        system_.evaluate(point_.configuration, factor);
        restart_prediction();
        return Termination::Converged;
    }

    /// Continue the path from a stable equilibrium that was not reached by a short step.
    void continue_from(Configuration configuration, double factor) {
        // The relative rotations of the elements are unknown.
        point_ = {std::move(configuration), factor, {}, {}, std::numbers::pi};
        mixed_is_here_ = is_at_rest_ = false;
    }

    /// Begin a path on a branch after a push. If the lowest eigenvalue of the branch counts as zero (see
    /// kNeutral), its direction is neutral: a symmetry turns the buckled shape about an axis.
    void begin_branch(double unstable_eigenvalue) {
        newton_.set_neutral({}, 0.0);
        const LowestMode mode = lowest_mode_here();
        if (mode.eigenvalue < kNeutral * std::abs(unstable_eigenvalue))
            newton_.set_neutral(mode.shape, rounding_shift(system_));
        restart_prediction();
    }

    /// The lowest mode of the last equilibrium, at which the system is evaluated.
    LowestMode lowest_mode_here() {
        system_.evaluate(point_.configuration, point_.load_factor);
        return lowest_mode(system_, newton_);
    }

    /// Restart the prediction from the last equilibrium. Each step has its own neutral direction, along which
    /// moves and rates do not count. Pre: the system is evaluated at the last equilibrium.
    void restart_prediction() {
        (void)newton_.factorize();
        point_.rate = newton_.solve_tangent(system_.load_rate());
        predictor_.restart();
        predictor_.add(point_.load_factor, point_.configuration, point_.rate);
    }

    /// Locate the loss of stability on the way to `unstable`, and continue on a stable branch if the options
    /// ask for one.
    /// @param move  step from the last equilibrium to `unstable`; empty: the path begins at `unstable`
    Termination leave(double factor, const Eigen::VectorXd& move, Configuration& unstable) {
        system_.evaluate(unstable, factor);
        LowestMode mode = lowest_mode(system_, newton_);
        StabilityLoss loss = describe_loss(system_, mode, factor);
        if (move.size() > 0)
            loss.load_factor =
                critical_load_factor(system_, newton_, point_, {factor, mode.eigenvalue}, move);
        if (options_.branch != Branch::Primary) {
            Configuration pushed = unstable;
            unknowns_.move(kPush * mode.shape / unknowns_.largest_component(mode.shape), pushed);
            const Termination found = descend(factor, system_, newton_, pushed);
            if (found != Termination::Converged) return found;
            loss.pushed = true;
            unknowns_.unwind(point_.configuration, pushed);
            continue_from(std::move(pushed), factor);
            begin_branch(mode.eigenvalue);
        } else {
            system_.evaluate(unstable, factor);
        }
        losses_.push_back(loss);
        return Termination::Converged;
    }

    [[nodiscard]] Solution solution(Termination termination) {
        if (termination != Termination::Converged) system_.evaluate(point_.configuration, point_.load_factor);
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
    NonlinearSystem system_;
    const Unknowns& unknowns_ = system_.unknowns();
    Newton newton_;
    MixedNewton mixed_;
    PathStepper stepper_;
    PathPoint point_;                                 ///< the last equilibrium
    Termination beginning_ = Termination::Converged;  ///< Converged if there is an equilibrium to begin at
    double least_load_scale_;
    bool is_at_rest_;
    bool mixed_is_here_;  ///< true if the stresses and factors of `mixed_` belong to the last equilibrium
    Eigen::VectorXd first_rate_;
    PathPredictor predictor_;
    std::vector<StabilityLoss> losses_;
};

LoadPath::LoadPath(const Assembly& assembly, const EquilibriumOptions& options,
                   const std::optional<PathStart>& start)
    : impl_(std::make_unique<Impl>(assembly, options, start)) {}
LoadPath::~LoadPath() = default;

Solution LoadPath::advance_to(double load_factor, const PathProgress& progress) {
    return impl_->advance_to(load_factor, progress);
}

PathEnd LoadPath::end() const {
    return impl_->end();
}

}  // namespace fretwork::mechanics::nonlinear
