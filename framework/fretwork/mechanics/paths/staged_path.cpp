// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/nonlinear/lowest_mode.hpp>
#include <fretwork/mechanics/paths/staged_path.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace fretwork::mechanics {
namespace {

using nonlinear::Configuration;

/// Shares of a stage.
constexpr double kFirstStep = 0.1;
constexpr double kShortestStep = 1.0 / 65536.0;
/// A stage begins, and goes on after a jump, with a short step: only then is it known how fast things move.
constexpr double kProbingStep = 1.0 / 256.0;
/// Newton's method may find an equilibrium far away, to which the structure would snap. A step that moves
/// this many times as fast as the one before is halved, and so is a first one that moves farther than the
/// second of these (rad, or element lengths); moves as small as the third are no jumps.
constexpr double kLargestGrowth = 3.0;
constexpr double kLargestProbe = 0.1;
constexpr double kSmallMove = 1e-3;
/// How far an unstable equilibrium is pushed along its lowest mode, in the same unit.
constexpr double kStagePush = 0.02;

using HeldValues = std::map<std::pair<int, int>, double>;  // by node and dof

HeldValues held_values(const StageTarget& target) {
    HeldValues held;
    for (const Support& support : target.supports) {
        for (int d = 0; d < kDofsPerNode; ++d)
            if (support.fixed.contains[d]) held[{support.node.value, d}] = 0.0;
    }
    for (const PrescribedDisplacement& given : target.prescribed)
        held[{given.node.value, static_cast<int>(given.dof)}] = given.value;
    return held;
}

double component(const Configuration& configuration, const std::pair<int, int>& place) {
    const std::size_t node = place.first;
    return place.second < 3 ? configuration.states[node].displacement[place.second]
                            : configuration.rotation_vectors[node][place.second - 3];
}

}  // namespace

class StagedPath::Impl {
  public:
    Impl(Assembly assembly, const EquilibriumOptions& options)
        : assembly_(std::move(assembly)), options_(options) {
        options_.validate();
        state_.states.resize(assembly_.nodes.size());
        state_.rotation_vectors.assign(assembly_.nodes.size(), Eigen::Vector3d::Zero());
        loads_ = NodeValues::Zero(std::ssize(assembly_.nodes), kDofsPerNode);
        reactions_ = loads_;
    }

    Solution advance(const StageTarget& target) {
        begin(target);
        nonlinear::NonlinearSystem system(assembly_, options_.threads, options_.control);
        nonlinear::Newton newton(system, options_);
        system.evaluate(state_, 1.0);
        if (is_at_rest_) newton.factorize_at_rest();
        double reached = 0.0;
        double step = kProbingStep;
        speed_ = 0.0;
        Termination termination = Termination::Converged;
        while (reached < 1.0 && termination == Termination::Converged) {
            options_.control.check();
            const double next = reached + step > 1.0 - 0.5 * kShortestStep ? 1.0 : reached + step;
            if (try_step(next, next - reached, system, newton)) {
                reached = next;
                step = std::min(2.0 * step, kFirstStep);
            } else if (step > kShortestStep) {
                step *= 0.5;
            } else if (options_.branch == Branch::Snapping && snap_to(next, system, newton)) {
                reached = next;
                step = kProbingStep;
                speed_ = 0.0;
            } else {
                termination = Termination::LimitLoad;
            }
        }
        return end(reached, termination, system, newton);
    }

  private:
    /// From where each held component and each load goes, and to where.
    void begin(const StageTarget& target) {
        const HeldValues held = held_values(target);
        from_loads_ = loads_;
        for (const auto& [place, value] : held_) {
            if (!held.contains(place))
                from_loads_(place.first, place.second) += reactions_(place.first, place.second);
        }
        to_loads_ = target.loads;
        from_.clear();
        for (const auto& [place, value] : held) from_[place] = component(state_, place);
        held_ = held;
        assembly_.supports.clear();
        take_up(0.0);
    }

    void take_up(double share) {
        assembly_.loads = (1.0 - share) * from_loads_ + share * to_loads_;
        assembly_.has_moments = !assembly_.loads.rightCols<3>().isZero(0.0);
        assembly_.prescribed.clear();
        for (const auto& [place, value] : held_) {
            const double now = (1.0 - share) * from_.at(place) + share * value;
            assembly_.prescribed.push_back({NodeIndex(place.first), static_cast<Dof>(place.second), now});
        }
    }

    /// The state with what is prescribed at a share of the stage.
    Configuration held_at(double share, nonlinear::NonlinearSystem& system) {
        take_up(share);
        system.refresh(options_.control);
        Configuration trial = state_;
        (void)system.unknowns().hold(trial);
        return trial;
    }

    /// Whether a step has moved farther than the path can have gone.
    [[nodiscard]] bool is_jump(double moved, double step) const {
        if (moved <= kSmallMove) return false;
        return speed_ > 0.0 ? moved > kLargestGrowth * speed_ * step : moved > kLargestProbe;
    }

    bool try_step(double share, double step, nonlinear::NonlinearSystem& system, nonlinear::Newton& newton) {
        Configuration trial = held_at(share, system);
        if (newton.solve(1.0, trial) != Termination::Converged) return false;
        system.unknowns().unwind(state_, trial);
        const double moved =
            system.unknowns().largest_component(system.unknowns().step_between(state_, trial));
        if (is_jump(moved, step)) return false;
        if (!newton.factorize().positive_definite()) return leave(share, trial, system, newton);
        state_ = std::move(trial);
        speed_ = std::max(moved, kSmallMove) / step;
        return true;
    }

    /// An unstable equilibrium is pushed along its lowest mode, and let down.
    bool leave(double share, const Configuration& unstable, nonlinear::NonlinearSystem& system,
               nonlinear::Newton& newton) {
        nonlinear::LowestMode mode = nonlinear::lowest_mode(system, newton);
        StabilityLoss loss = nonlinear::describe_loss(system, mode);
        Configuration pushed = unstable;
        system.unknowns().move(kStagePush * mode.shape / system.unknowns().largest_component(mode.shape),
                               pushed);
        return go_down(share, loss, pushed, system, newton);
    }

    bool snap_to(double share, nonlinear::NonlinearSystem& system, nonlinear::Newton& newton) {
        return go_down(share, {}, held_at(share, system), system, newton);
    }

    bool go_down(double share, StabilityLoss loss, Configuration trial, nonlinear::NonlinearSystem& system,
                 nonlinear::Newton& newton) {
        if (nonlinear::descend(1.0, system, newton, trial) != Termination::Converged) return false;
        system.unknowns().unwind(state_, trial);
        if (!loss.node.is_valid()) {
            nonlinear::LowestMode jump{0.0, system.unknowns().step_between(state_, trial)};
            loss = nonlinear::describe_loss(system, jump);
        }
        loss.load_factor = share;
        loss.pushed = true;
        losses_.push_back(loss);
        state_ = std::move(trial);
        return true;
    }

    Solution end(double reached, Termination termination, nonlinear::NonlinearSystem& system,
                 nonlinear::Newton& newton) {
        Configuration last = held_at(reached, system);
        system.evaluate(last, 1.0);
        Solution solution = system.describe(last, reached);
        solution.termination = termination;
        solution.stable = newton.factorize().positive_definite();
        solution.stability = system.stability_test();
        solution.iterations = newton.take_iterations();
        solution.stability_losses = std::exchange(losses_, {});
        loads_ = assembly_.loads;
        reactions_.topRows(solution.reactions.rows()) = solution.reactions;
        is_at_rest_ = false;
        return solution;
    }

    Assembly assembly_;
    EquilibriumOptions options_;
    Configuration state_;  ///< the last equilibrium
    bool is_at_rest_ = true;
    double speed_ = 0.0;  ///< of the last step, in rad or element lengths a stage; 0: not known
    HeldValues held_;     ///< at the end of the stage
    HeldValues from_;     ///< the same components at its beginning
    NodeValues loads_;    ///< at the last equilibrium
    NodeValues reactions_;
    NodeValues from_loads_;
    NodeValues to_loads_;
    std::vector<StabilityLoss> losses_;
};

StagedPath::StagedPath(Assembly assembly, const EquilibriumOptions& options)
    : impl_(std::make_unique<Impl>(std::move(assembly), options)) {}
StagedPath::StagedPath(StagedPath&&) noexcept = default;
StagedPath& StagedPath::operator=(StagedPath&&) noexcept = default;
StagedPath::~StagedPath() = default;

Solution StagedPath::advance(const StageTarget& target) {
    return impl_->advance(target);
}

}  // namespace fretwork::mechanics
