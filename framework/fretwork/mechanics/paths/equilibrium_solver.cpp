// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/mechanics/nonlinear/stride.hpp>
#include <fretwork/mechanics/nonlinear/tangent_at.hpp>
#include <fretwork/mechanics/paths/equilibrium_solver.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace fretwork::mechanics {
namespace {

using nonlinear::Configuration;
using nonlinear::PathPoint;

/// The largest rotation of a node, rad, in the first step after an edit; after a larger one, the solution
/// starts from rest.
constexpr double kLongestStep = 1.0;

/// An assembly with its equations and their factors.
struct Equations {
    Equations(const Assembly& its_assembly, const EquilibriumOptions& options)
        : assembly(its_assembly),
          system(assembly, options.threads, options.control),
          newton(system, options),
          mixed(system, newton, options) {}
    Assembly assembly;
    nonlinear::NonlinearSystem system;
    nonlinear::Newton newton;
    nonlinear::MixedNewton mixed;
};

bool have_equal_nodes(const Element& a, const Element& b) {
    return std::ranges::equal(a.nodes(), b.nodes()) && a.stress_count() == b.stress_count();
}

bool have_equal_equations(const Assembly& a, const Assembly& b) {
    return structure::constraints_of(a).held == structure::constraints_of(b).held &&
           std::ranges::equal(a.elements, b.elements, [](const auto& one, const auto& other) {
               return one == other || have_equal_nodes(*one, *other);
           });
}

bool have_equal_rotation_vectors(const Assembly& a, const Assembly& b) {
    return structure::constraints_of(a).values.rightCols<3>() ==
           structure::constraints_of(b).values.rightCols<3>();
}

/// The configuration of a solution under its full load.
Configuration configuration_of(const Solution& solution) {
    Configuration configuration;
    for (const NodeValues* table : {&solution.displacements, &solution.inner_displacements}) {
        for (const auto& row : table->rowwise()) {
            const Eigen::Vector3d vector = row.tail<3>().transpose();
            configuration.states.push_back({row.head<3>().transpose(), geometry::exponential(vector)});
            configuration.rotation_vectors.push_back(vector);
        }
    }
    return configuration;
}

}  // namespace

class EquilibriumSolver::Impl {
  public:
    explicit Impl(const EquilibriumOptions& options)
        : options_(options), is_classifying_(options.classify_stability) {
        options_.validate();
    }

    Solution solve(const Assembly& assembly, const base::Control& control, StabilityCheck check,
                   const FirstIterate& first_iterate) {
        options_.control = control;
        options_.classify_stability = is_classifying_ && check == StabilityCheck::Made;
        const bool may_go_on = is_settled_ && assembly.nodes == equations_->assembly.nodes &&
                               !holds_what_has_moved_away(assembly);
        is_settled_ = has_converged_ = false;  // both stay false after an error
        if (may_go_on) {
            starting_point_ = StartingPoint::LastEquilibrium;
            if (auto solution = go_on(assembly, first_iterate)) return std::move(*solution);
        }
        starting_point_ = StartingPoint::Rest;
        return from_rest(assembly);
    }

    [[nodiscard]] StartingPoint starting_point() const { return starting_point_; }

    EquilibriumTangent tangent(const base::Control& control) {
        if (!has_converged_)
            throw base::InputError(
                "there is no equilibrium to take derivatives at: the last solution has not converged");
        options_.control = control;
        if (!equations_) equations_ = std::make_unique<Equations>(*followed_, options_);
        auto& [own, system, newton, mixed] = *equations_;
        if (std::exchange(is_given_up_, false)) has_factors_ = false;
        return EquilibriumTangent(std::make_unique<EquilibriumTangent::Impl>(
            EquilibriumTangent::Impl::Parts{system, newton, mixed, options_, point_.configuration,
                                            has_factors_},
            control));
    }

  private:
    [[nodiscard]] bool needs_the_whole_path() const {
        return options_.branch != Branch::Primary || options_.locate_critical_loads;
    }

    Solution from_rest(const Assembly& assembly) {
        if (needs_the_whole_path()) {
            equations_.reset();  // those of an earlier tangent() belong to another assembly
        } else if (auto solution = stride_from_rest(assembly)) {
            return std::move(*solution);
        }
        constexpr double kFullLoad[] = {1.0};
        Solution solution = follow_load_path(assembly, kFullLoad, options_).back();
        has_converged_ = solution.converged();
        is_settled_ = equations_ && has_converged_ && solution.stable;
        if (!equations_) followed_ = assembly;
        point_ = {configuration_of(solution), 1.0, {}, {}, std::numbers::pi};
        has_factors_ = false;
        return solution;
    }

    std::optional<Solution> stride_from_rest(const Assembly& assembly) {
        const base::Task task(options_.control, "load path (thousandths of the load)", 1000);
        is_given_up_ = false;
        if (equations_ && assembly.nodes == equations_->assembly.nodes) {
            adopt(assembly);
        } else {
            equations_ = std::make_unique<Equations>(assembly, options_);
        }
        auto& [own, system, newton, mixed] = *equations_;
        // Drop the iterations of an attempt from the last equilibrium that was given up.
        (void)newton.take_iterations();
        point_ = {system.unknowns().rest(), 0.0, {}, {}, 0.0};
        mixed.begin_at_rest(point_.configuration);
        point_.rate = newton.solve_tangent(system.load_rate());
        if (nonlinear::stride(system, newton, mixed, point_, 1.0) != Termination::Converged) return {};
        return settled();
    }

    /// The solution at the equilibrium of the system's last evaluation. Pre: the factors belong to a tangent
    /// near that at the equilibrium.
    Solution settled() {
        is_settled_ = has_factors_ = has_converged_ = true;
        Solution solution = equations_->system.describe(point_.configuration, 1.0);
        is_checked_ = options_.classify_stability;
        if (is_checked_) solution.stability = equations_->system.stability_test();
        solution.iterations = equations_->newton.take_iterations();
        return solution;
    }

    /// True if a newly held component is so far from its value that the first step would turn nodes by about
    /// a radian. An attempt from the last equilibrium is then not worth new factors.
    [[nodiscard]] bool holds_what_has_moved_away(const Assembly& assembly) const {
        const structure::Constraints wanted = structure::constraints_of(assembly);
        const auto& unknowns = equations_->system.unknowns();
        const auto& [states, vectors] = point_.configuration;
        for (std::size_t node = 0; node < states.size(); ++node) {
            for (int d = 0; d < kDofsPerNode; ++d) {
                if (!wanted.held[node].contains[d] || unknowns.is_held(static_cast<int>(node), d)) continue;
                const double is =
                    d < 3 ? states[node].displacement[d] / unknowns.length() : vectors[node][d - 3];
                const double unit = d < 3 ? unknowns.length() : 1.0;
                const double will_be = wanted.values(static_cast<Eigen::Index>(node), d) / unit;
                if (std::abs(will_be - is) > kLongestStep) return true;
            }
        }
        return false;
    }

    void adopt(const Assembly& assembly) {
        if (!have_equal_equations(equations_->assembly, assembly)) {
            equations_ = std::make_unique<Equations>(assembly, options_);
            has_factors_ = false;
            return;
        }
        // The slopes refer to components of rotation vectors at nodes at which these are prescribed.
        has_factors_ = has_factors_ && equations_->assembly.elements == assembly.elements &&
                       have_equal_rotation_vectors(equations_->assembly, assembly);
        equations_->assembly = assembly;
        equations_->system.refresh(options_.control);
    }

    /// Continue from the last equilibrium. After a stop on the way, the last equilibrium stays the starting
    /// point.
    std::optional<Solution> go_on(const Assembly& assembly, const FirstIterate& first_iterate) {
        try {
            adopt(assembly);
            return find_next(first_iterate);
        } catch (const base::Stopped&) {
            is_settled_ = is_given_up_ = true;
            throw;
        }
    }

    std::optional<Solution> find_next(const FirstIterate& first_iterate) {
        auto& [own, system, newton, mixed] = *equations_;
        if (std::exchange(is_given_up_, false))
            has_factors_ = has_factors_ && mixed.come_back(point_.configuration);
        if (!has_factors_ && !mixed.begin(point_.configuration, 1.0)) return {};
        has_factors_ = true;
        if (!mixed.outcome().positive_definite()) return {};
        PathPoint next = point_;
        const auto first = mixed.depart(next.configuration);
        if (first.step.size() == 0) return settled_again();
        if (!(system.unknowns().largest_rotation(first.step) <= kLongestStep)) return {};
        if (!(turn_of_held(next.configuration) <= kLongestStep)) return {};
        if (first_iterate) first_iterate(iterate_at(next.configuration));
        const Termination found =
            mixed.solve(1.0, nonlinear::MixedNewton::Goal::Equilibrium, first.step, next.configuration);
        if (found != Termination::Converged || !is_near(first, next)) return {};
        point_ = std::move(next);
        return settled();
    }

    [[nodiscard]] Solution iterate_at(const Configuration& configuration) const {
        Solution iterate = equations_->system.describe(configuration, 1.0);
        iterate.termination = Termination::IterationsSpent;
        iterate.stability = StabilityTest::None;
        iterate.iterations = 1;
        iterate.reactions.setZero();  // the reactions belong to the configuration before
        return iterate;
    }

    /// The solution again, if nothing has changed. Nothing if the equilibrium has lost its stability in
    /// unchecked solutions.
    std::optional<Solution> settled_again() {
        auto& [own, system, newton, mixed] = *equations_;
        if (options_.classify_stability && !is_checked_) {
            if (!mixed.begin(point_.configuration, 1.0)) return {};
            if (!mixed.outcome().positive_definite()) return {};
        }
        return settled();
    }

    /// The largest turn of a node with held rotation components from the last equilibrium, rad. Elements
    /// know rotations only up to whole turns, so a larger turn could pass for one in the opposite sense.
    [[nodiscard]] double turn_of_held(const Configuration& next) const {
        const auto& last = point_.configuration.rotation_vectors;
        double largest = 0.0;
        for (std::size_t node = 0; node < last.size(); ++node) {
            if (equations_->system.unknowns().has_held_rotation(static_cast<int>(node)))
                largest = std::max(largest, (next.rotation_vectors[node] - last[node]).norm());
        }
        return largest;
    }

    /// True if the last equilibrium and the next one seem to lie on one path.
    bool is_near(const nonlinear::MixedNewton::FirstStep& first, PathPoint& next) {
        auto& [own, system, newton, mixed] = *equations_;
        const auto& unknowns = system.unknowns();
        unknowns.unwind(point_.configuration, next.configuration);
        const Eigen::VectorXd move = unknowns.step_between(point_.configuration, next.configuration);
        const double turned = std::max(unknowns.largest_rotation(move), turn_of_held(next.configuration));
        next.turn_bound = nonlinear::bound_relative_turn(system, point_, turned, next.configuration);
        if (next.turn_bound > std::numbers::pi) return false;
        const Eigen::VectorXd last_step = newton.solve_tangent(first.unbalanced);
        return !nonlinear::is_jump(unknowns, move.cwiseAbs(),
                                   first.step.cwiseAbs().cwiseMax(last_step.cwiseAbs()));
    }

    EquilibriumOptions options_;
    /// classify_stability in the caller's options; in `options_`, it also depends on the StabilityCheck.
    bool is_classifying_;
    std::unique_ptr<Equations> equations_;
    PathPoint point_;                   ///< last equilibrium, if is_settled_ or has_converged_
    bool is_settled_ = false;           ///< true if there is a last equilibrium to continue from
    std::optional<Assembly> followed_;  ///< last assembly, if it has no equations
    bool has_converged_ = false;        ///< true if the point is an equilibrium of the last assembly
    bool has_factors_ = false;          ///< true if the factors belong to a tangent near the last equilibrium
    /// True if an attempt from the last equilibrium was given up, so that the factors may be outdated.
    bool is_given_up_ = false;
    bool is_checked_ = false;  ///< true if the factors belong to the last equilibrium, which is stable
    StartingPoint starting_point_ = StartingPoint::Rest;
};

EquilibriumSolver::EquilibriumSolver(const EquilibriumOptions& options)
    : impl_(std::make_unique<Impl>(options)) {}
EquilibriumSolver::EquilibriumSolver(EquilibriumSolver&&) noexcept = default;
EquilibriumSolver& EquilibriumSolver::operator=(EquilibriumSolver&&) noexcept = default;
EquilibriumSolver::~EquilibriumSolver() = default;

Solution EquilibriumSolver::solve(const Assembly& assembly, const base::Control& control,
                                  StabilityCheck check, const FirstIterate& first_iterate) {
    return impl_->solve(assembly, control, check, first_iterate);
}

EquilibriumTangent EquilibriumSolver::tangent(const base::Control& control) {
    return impl_->tangent(control);
}

StartingPoint EquilibriumSolver::starting_point() const {
    return impl_->starting_point();
}

}  // namespace fretwork::mechanics
