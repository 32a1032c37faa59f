// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/nonlinear/path_step.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fretwork::mechanics::nonlinear {
namespace {

constexpr int kMostCorrections = 15;
/// The ratio of a correction to the correction before it above which the iteration does not converge.
constexpr double kLargestGrowth = 2.0;

/// The largest deviation of a move from the mean of the directions at its ends, as a share of each component.
/// A component that moves less than kOwnShare of the largest counts as moving by this share. With a larger
/// deviation, the equilibrium is on another branch, or too far away to decide.
constexpr double kUnexplained = 0.3;
constexpr double kOwnShare = 0.3;
/// Along the arc, where bends may be sharp, only moves below this size (rad, and element lengths) count as
/// linear.
constexpr double kRoundedMove = 1e-8;
/// The smallest cosine of the angle between the directions at the ends of a step: 60 degrees.
constexpr double kLeastCosine = 0.5;
/// The largest size of the first step of a path, rad or element lengths.
constexpr double kFirstMove = 0.1;
/// The largest prescribed rotation of a node in a step, rad.
constexpr double kMostPrescribedTurn = 0.7;
/// The largest length of a step that ends within another step, as a multiple of the other step's length.
constexpr double kWithin = 1.05;
/// The largest curved part of a guess, as a share of its straight part.
constexpr double kMostCurved = 0.5;

}  // namespace

int correct_across(NonlinearSystem& system, Newton& newton, const Eigen::VectorXd& step, double& load_factor,
                   Configuration& trial) {
    const Unknowns& unknowns = system.unknowns();
    const Eigen::VectorXd normal = unknowns.weights().cwiseProduct(step);
    Eigen::VectorXd move;
    double last_size = 0.0;
    for (int iteration = 0; iteration <= kMostCorrections; ++iteration) {
        system.evaluate(trial, load_factor);
        if (!std::isfinite(system.relative_residual())) return -1;
        if (newton.is_converged(trial, move)) return iteration;
        if (newton.factorize().zero_pivot >= 0) return -1;
        const Eigen::VectorXd rate = newton.solve_tangent(system.load_rate());
        move = newton.solve_tangent(system.unbalanced());
        const double load_step = -normal.dot(move) / normal.dot(rate);
        move += load_step * rate;
        const double size = unknowns.size_of(move);
        if (!std::isfinite(load_step) || !std::isfinite(size)) return -1;
        if (iteration > 1 && size > kLargestGrowth * last_size) return -1;
        last_size = size;
        load_factor += load_step;
        unknowns.prescribe(load_factor, trial);
        unknowns.move(move, trial);
    }
    return -1;
}

PathState PathStepper::rising(PathPoint point) const {
    const double size = std::max(unknowns_.size_of(point.rate), 1e-300);
    Eigen::VectorXd direction = point.rate / size;
    return {std::move(point), std::move(direction), 1.0 / size};
}

double PathStepper::length_of(const PathState& from, double largest_component) const {
    return largest_component / std::max(unknowns_.largest_component(from.direction), 1e-300);
}

double PathStepper::first_length(const PathState& from, double load_factor) const {
    return std::min(length_of(from, kFirstMove), (load_factor - from.point.load_factor) / from.load_rate);
}

/// The continuation of the cubic through the last two states and their directions (Hermite); the straight
/// continuation if the cubic bends too much.
PathStepper::Guess PathStepper::predict(const PathState& from, const PathState* previous,
                                        double length) const {
    Guess guess{length * from.direction, length * from.load_rate};
    if (previous != nullptr) {
        const Eigen::VectorXd back =
            unknowns_.step_between(from.point.configuration, previous->point.configuration);
        const double chord = unknowns_.size_of(back);
        const double t = length / chord;
        const Eigen::VectorXd back_direction = unknowns_.rate_of_steps(back, previous->direction);
        const Eigen::VectorXd cubic = chord * (back_direction + from.direction) + 2.0 * back;
        const Eigen::VectorXd square = back + chord * from.direction + cubic;
        const Eigen::VectorXd bend = t * t * square + t * t * t * cubic;
        if (unknowns_.size_of(bend) <= kMostCurved * length) {
            guess.move += bend;
            const double load_back = previous->point.load_factor - from.point.load_factor;
            const double load_cubic = chord * (previous->load_rate + from.load_rate) + 2.0 * load_back;
            const double load_square = load_back + chord * from.load_rate + load_cubic;
            guess.load_factor += t * t * load_square + t * t * t * load_cubic;
        }
    }
    guess.load_factor += from.point.load_factor;
    return guess;
}

std::optional<PathStep> PathStepper::step(const PathState& from, const PathState* previous, double length) {
    Guess guess = predict(from, previous, length);
    if (unknowns_.largest_rotation(guess.move) > options_.largest_rotation_step) return {};
    const double load_step = std::abs(guess.load_factor - from.point.load_factor);
    if (load_step * unknowns_.largest_prescribed_rotation() > kMostPrescribedTurn) return {};
    Configuration trial = from.point.configuration;
    unknowns_.prescribe(guess.load_factor, trial);
    unknowns_.move(guess.move, trial);
    if (correct_across(system_, newton_, guess.move, guess.load_factor, trial) < 0) return {};
    const auto outcome = newton_.factorize();
    if (outcome.zero_pivot >= 0) return {};
    auto step = step_to(from, {std::move(trial), guess.load_factor, outcome});
    if (!step) return {};
    // Along such a short step, rounding decides the sign of the load rate.
    if (step->state.load_rate < 0.0 && unknowns_.largest_component(step->move) <= kRoundedMove) return {};
    step->deviation = deviation_on_arc(from, *step);
    return step->deviation <= 1.0 ? std::move(step) : std::nullopt;
}

std::optional<PathStep> PathStepper::step_to_load(const PathState& from, double load_factor,
                                                  const Eigen::VectorXd& guess) {
    auto arrival = correct_under_load(from, load_factor, guess);
    if (!arrival) return {};
    auto step = step_to(from, std::move(*arrival));
    if (!step) return {};
    // The rates of components that stand still are rounding, and so is the direction in which they move.
    if (unknowns_.largest_component(step->move) <= kRoundedMove)
        step->state = rising(std::move(step->state.point));
    const double span = load_factor - from.point.load_factor;
    const double at_last_rate = span * unknowns_.largest_component(step->state.point.rate);
    if (at_last_rate > kLinearMove && is_softened(unknowns_, from.point.rate, step->state.point.rate))
        return {};
    if (unknowns_.largest_component(step->move) <= kLinearMove) return step;
    const double half = 0.5 * span;
    step->deviation = deviation(step->move, half * (from.point.rate + step->state.point.rate));
    return step->deviation <= 1.0 ? std::move(step) : std::nullopt;
}

std::optional<PathStep> PathStepper::step_within(const PathState& from, const PathStep& known,
                                                 double load_factor) {
    const double share =
        (load_factor - from.point.load_factor) / (known.state.point.load_factor - from.point.load_factor);
    auto arrival = correct_under_load(from, load_factor, share * known.move);
    if (!arrival) return {};
    auto step = step_to(from, std::move(*arrival));
    if (!step || step->length > kWithin * known.length) return {};
    step->deviation = deviation_on_arc(from, *step);
    return step->deviation <= 1.0 ? std::move(step) : std::nullopt;
}

std::optional<PathStepper::Arrival> PathStepper::correct_under_load(const PathState& from, double load_factor,
                                                                    const Eigen::VectorXd& guess) {
    Configuration trial = from.point.configuration;
    unknowns_.prescribe(load_factor, trial);
    unknowns_.move(guess, trial);
    const auto outcome = newton_.solve_and_factorize(load_factor, guess, trial);
    if (!outcome) return {};
    return Arrival{std::move(trial), load_factor, *outcome};
}

std::optional<PathStep> PathStepper::step_to(const PathState& from, Arrival arrival) {
    auto& [trial, load_factor, outcome] = arrival;
    unknowns_.unwind(from.point.configuration, trial);
    PathStep step;
    step.move = unknowns_.step_between(from.point.configuration, trial);
    const double turn_bound = bound_relative_turn(system_, from.point, step.move, load_factor, trial);
    if (turn_bound > std::numbers::pi) return {};
    Eigen::VectorXd rate = newton_.solve_tangent(system_.load_rate());
    const double forward = unknowns_.product(rate, step.move) >= 0.0 ? 1.0 : -1.0;
    step.state = rising({std::move(trial), load_factor, std::move(rate), outcome, turn_bound});
    step.state.direction *= forward;
    step.state.load_rate *= forward;
    step.length = unknowns_.size_of(step.move);
    return step;
}

double PathStepper::deviation_on_arc(const PathState& from, const PathStep& step) const {
    const double cosine = unknowns_.product(from.direction, step.state.direction);
    if (unknowns_.largest_component(step.move) <= kRoundedMove) return 0.0;
    if (cosine < kLeastCosine) return 2.0;
    const Eigen::VectorXd mean = from.direction + step.state.direction;
    return deviation(step.move, step.length / std::max(unknowns_.size_of(mean), 1e-300) * mean);
}

double PathStepper::deviation(const Eigen::VectorXd& move, const Eigen::VectorXd& explained) const {
    const Eigen::ArrayXd unit = unknowns_.weights().array().sqrt();
    const Eigen::ArrayXd expected = unit * explained.array();
    const Eigen::ArrayXd made = unit * move.array();
    const Eigen::ArrayXd own = expected.abs().max(made.abs());
    return ((made - expected).abs() / (kUnexplained * own.max(kOwnShare * own.maxCoeff()))).maxCoeff();
}

}  // namespace fretwork::mechanics::nonlinear
