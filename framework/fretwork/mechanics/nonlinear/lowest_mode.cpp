// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/nonlinear/lowest_mode.hpp>
#include <fretwork/mechanics/sparse/arbitrary.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::mechanics::nonlinear {
namespace {

constexpr int kMostIterations = 300;
constexpr double kTolerance = 1e-10;

/// The shift relative to the mean stiffness, a few hundred times the rounding of the stiffness.
constexpr double kRoundingShift = 1e-13;

/// The largest rotation (rad) or displacement (element lengths) of a node in a step of a descent.
constexpr double kDownhillStep = 0.1;
constexpr int kMostDownhillSteps = 2000;

/// The relative accuracy of critical loads, and the largest number of equilibria to find one.
constexpr double kCriticalWidth = 1e-6;
constexpr int kCriticalSteps = 30;

/// The mean of the tangent's diagonal relative to the system's weights.
double mean_stiffness(const NonlinearSystem& system) {
    double sum = 0.0;
    for (int i = 0; i < system.unknowns().equations(); ++i) {
        const auto k = system.unknowns().layout().column_start()[i];
        sum += std::abs(system.tangent()[k]) / system.unknowns().weights()[i];
    }
    return sum / std::max(system.unknowns().equations(), 1);
}

/// Factorize the tangent with the smallest of the shifts `first`, 4 `first`, .. that makes it positive
/// definite. Returns this shift.
double shift_to_definite(Newton& newton, double first) {
    double shift = first;
    while (!newton.factorize(shift).positive_definite() && std::isfinite(shift)) shift *= 4.0;
    return shift;
}

/// The largest component of a mode among the nodes [first, last); an invalid node if none of them moves.
StabilityLoss largest_component_of(const NonlinearSystem& system, const LowestMode& mode,
                                   std::ptrdiff_t first, std::ptrdiff_t last) {
    constexpr double kNoMove = 1e-9;
    StabilityLoss loss;
    double largest = kNoMove * system.unknowns().largest_component(mode.shape);
    for (auto node = static_cast<int>(first); node < static_cast<int>(last); ++node) {
        for (int d = 0; d < kDofsPerNode; ++d) {
            const int equation = system.unknowns().layout().equation(node, d);
            if (equation < 0) continue;
            const double size =
                std::abs(mode.shape[equation]) * std::sqrt(system.unknowns().weights()[equation]);
            if (size <= largest) continue;
            largest = size;
            loss.node = NodeIndex(node);
            loss.dof = static_cast<Dof>(d);
        }
    }
    return loss;
}

}  // namespace

double rounding_shift(const NonlinearSystem& system) {
    return kRoundingShift * mean_stiffness(system);
}

LowestMode lowest_mode(const NonlinearSystem& system, Newton& newton) {
    const double shift = shift_to_definite(newton, rounding_shift(system));
    Eigen::VectorXd x = sparse::arbitrary_numbers(system.unknowns().equations());
    double eigenvalue = 0.0;
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
        const Eigen::VectorXd weighted = system.unknowns().weights().cwiseProduct(x);
        Eigen::VectorXd next = weighted;
        newton.solve_symmetric(next);
        const double found = x.dot(weighted) / next.dot(weighted) - shift;
        x = next / system.unknowns().size_of(next);
        const bool settled = std::abs(found - eigenvalue) <= kTolerance * (std::abs(found) + shift);
        eigenvalue = found;
        if (settled && iteration > 2) break;
    }
    Eigen::Index largest = 0;
    x.cwiseProduct(system.unknowns().weights().cwiseSqrt()).cwiseAbs().maxCoeff(&largest);
    return {eigenvalue, x / (x[largest] * std::sqrt(system.unknowns().weights()[largest]))};
}

StabilityLoss describe_loss(const NonlinearSystem& system, LowestMode& mode, double load_factor) {
    const Assembly& assembly = system.unknowns().assembly();
    StabilityLoss loss = largest_component_of(system, mode, 0, assembly.reported_nodes);
    if (!loss.node.is_valid())
        loss = largest_component_of(system, mode, assembly.reported_nodes, std::ssize(assembly.nodes));
    loss.load_factor = load_factor;
    if (!loss.node.is_valid()) return loss;
    if (mode.shape[system.unknowns().layout().equation(loss.node.value, static_cast<int>(loss.dof))] < 0.0)
        mode.shape = -mode.shape;
    if (loss.node.value >= assembly.reported_nodes)
        loss.node = structure::nearest_reported(assembly, loss.node);
    return loss;
}

Termination descend(double load_factor, NonlinearSystem& system, Newton& newton,
                    Configuration& configuration) {
    Eigen::VectorXd step;
    for (int iteration = 0; iteration < kMostDownhillSteps; ++iteration) {
        system.evaluate(configuration, load_factor);
        if (!std::isfinite(system.relative_residual())) return Termination::Diverged;
        const bool definite = newton.factorize(rounding_shift(system)).positive_definite();
        if (definite && newton.is_converged(configuration, step)) return Termination::Converged;
        step = system.unbalanced();
        if (definite) {
            step = newton.solve_tangent(step);
        } else {
            shift_to_definite(newton, rounding_shift(system));
            newton.solve_symmetric(step);
        }
        const double turn =
            std::max(system.unknowns().largest_rotation(step), system.unknowns().largest_component(step));
        if (!std::isfinite(turn)) return Termination::Diverged;
        system.unknowns().move(step * std::min(1.0, kDownhillStep / std::max(turn, 1e-300)), configuration);
    }
    return Termination::IterationsSpent;
}

double critical_load_factor(NonlinearSystem& system, Newton& newton, const PathPoint& from,
                            LowestEigenvalue unstable, const Eigen::VectorXd& move) {
    const double span = unstable.load_factor - from.load_factor;
    system.evaluate(from.configuration, from.load_factor);
    LowestEigenvalue stable{from.load_factor, lowest_mode(system, newton).eigenvalue};
    const auto vanishing = [&] {
        const double share = stable.eigenvalue / (stable.eigenvalue - unstable.eigenvalue);
        return stable.load_factor + std::clamp(share, 0.0, 1.0) * (unstable.load_factor - stable.load_factor);
    };
    int side = 0;
    for (int i = 0; i < kCriticalSteps; ++i) {
        if (unstable.load_factor - stable.load_factor <= kCriticalWidth * unstable.load_factor) break;
        const double factor = vanishing();
        Configuration trial = from.configuration;
        system.unknowns().prescribe(factor, trial);
        system.unknowns().move(((factor - from.load_factor) / span) * move, trial);
        if (newton.solve(factor, trial) != Termination::Converged) break;
        const LowestEigenvalue found{factor, lowest_mode(system, newton).eigenvalue};
        const bool is_stable = found.eigenvalue > 0.0;
        if (side == (is_stable ? 1 : -1)) (is_stable ? unstable : stable).eigenvalue *= 0.5;
        side = is_stable ? 1 : -1;
        (is_stable ? stable : unstable) = found;
    }
    return vanishing();
}

}  // namespace fretwork::mechanics::nonlinear
