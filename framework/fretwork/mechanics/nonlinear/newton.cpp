// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/nonlinear/newton.hpp>
#include <fretwork/mechanics/structure/mechanism.hpp>

#include <Eigen/Jacobi>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fretwork::mechanics::nonlinear {
namespace {

/// The accuracy of solutions with the skew part; Newton's method corrects the rest.
constexpr double kSkewTolerance = 1e-6;
constexpr int kMostSkewIterations = 60;

/// The size of a step (rotations in rad, displacements in element lengths) that changes nothing but rounding.
constexpr double kNegligibleStep = 1e-13;
/// Such a step ends the iteration if the residual, which is the error of the reactions, is below this limit.
/// In short beams beside long beams, the rounding of cancelling forces can keep the residual above
/// EquilibriumOptions::relative_residual.
constexpr double kResidualFloor = 1e-4;
/// The size of displacements (rad, and element lengths) below which they are linear in the load. The first
/// prediction is then exact, and its residual comes from the rounding of positions in the elements' geometry.
constexpr double kLinearReach = 1e-7;

/// The distance (rad and element lengths, and as a share of the way to a configuration) within which factors
/// count as the factors of the configuration. Both are small, because a load that hardly moves a column may
/// change its stability.
constexpr double kNegligibleMove = 2e-4;
constexpr double kNegligibleShare = 1e-3;

/// Refinement ends if a step is below this share of the solution.
constexpr double kRefinedStep = 1e-13;
/// It also ends if steps no longer shrink by this factor. The cause is rounding if the step is below the
/// share kLeastRefined; otherwise, the factors are too far from the tangent, and no solution is returned.
constexpr double kSlowRefinement = 0.3;
constexpr double kLeastRefined = 1e-9;

/// Solve (1 + B) x = b by GMRES, where B is the inverse of the symmetric part times the skew part. The rank
/// of B is at most two for each node with a moment, so a few steps are exact. Givens rotations keep the small
/// problem triangular, and give the residual at each step.
template <class Operator>
Eigen::VectorXd solve_near_identity(const Operator& b_times, const Eigen::VectorXd& right_side) {
    const double size = right_side.norm();
    if (size == 0.0) return right_side;
    std::vector<Eigen::VectorXd> basis{right_side / size};
    Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(kMostSkewIterations + 1, kMostSkewIterations);
    Eigen::VectorXd target = size * Eigen::VectorXd::Unit(kMostSkewIterations + 1, 0);
    std::vector<Eigen::JacobiRotation<double>> rotations;
    int k = 0;
    for (bool done = false; !done && k < kMostSkewIterations; ++k) {
        Eigen::VectorXd next = basis.back() + b_times(basis.back());
        for (int i = 0; i <= k; ++i) {
            triangle(i, k) = basis[i].dot(next);
            next -= triangle(i, k) * basis[i];
        }
        const double length = triangle(k + 1, k) = next.norm();
        for (int i = 0; i < k; ++i) triangle.col(k).applyOnTheLeft(i, i + 1, rotations[i].adjoint());
        Eigen::JacobiRotation<double> rotation;
        rotation.makeGivens(triangle(k, k), triangle(k + 1, k));
        triangle.col(k).applyOnTheLeft(k, k + 1, rotation.adjoint());
        target.applyOnTheLeft(k, k + 1, rotation.adjoint());
        rotations.push_back(rotation);
        done = std::abs(target[k + 1]) <= kSkewTolerance * size;
        if (!done) basis.push_back(next / length);
    }
    const Eigen::VectorXd weights =
        triangle.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(target.head(k));
    Eigen::VectorXd x = Eigen::VectorXd::Zero(right_side.size());
    for (Eigen::Index i = 0; i < k; ++i) x += weights[i] * basis[i];
    return x;
}

}  // namespace

void Newton::factorize_at_rest() {
    const sparse::Ldlt::Outcome outcome = factorize();
    structure::refuse_mechanisms(unknowns_.assembly(), unknowns_.layout(), system_.tangent(), factors_,
                                 outcome, options_.control);
}

sparse::Ldlt::Outcome Newton::factorize() {
    if (neutral_.size() > 0) return factorize(neutral_shift_);
    return factors_.factorize(system_.tangent(), options_.control);
}

sparse::Ldlt::Outcome Newton::factorize(double shift) {
    shifted_.assign(system_.tangent().begin(), system_.tangent().end());
    const auto& start = unknowns_.layout().column_start();
    for (int i = 0; i < unknowns_.equations(); ++i) shifted_[start[i]] += shift * unknowns_.weights()[i];
    return factors_.factorize(shifted_, options_.control);
}

void Newton::set_neutral(Eigen::VectorXd direction, double shift) {
    neutral_ = std::move(direction);
    if (neutral_.size() > 0) neutral_ /= unknowns_.size_of(neutral_);
    neutral_shift_ = shift;
}

/// The solution without motion along the neutral direction n. As K n = 0, solutions of K are unique only up
/// to multiples of n. The wanted solution is the solution of K bordered with n; n itself follows from the
/// solution with the bordering column.
Eigen::VectorXd Newton::without_neutral_part(Eigen::VectorXd x) {
    if (neutral_.size() == 0) return x;
    const Eigen::VectorXd along = unknowns_.weights().cwiseProduct(neutral_);
    Eigen::VectorXd moved = along;
    factors_.solve(moved, options_.control);
    x -= along.dot(x) / along.dot(moved) * moved;
    return x;
}

void Newton::solve_symmetric(Eigen::VectorXd& right_side) {
    factors_.solve(right_side, options_.control);
    ++iterations_;
}

Eigen::VectorXd Newton::solve_tangent(const Eigen::VectorXd& right_side) {
    Eigen::VectorXd x = right_side;
    factors_.solve(x, options_.control);
    ++iterations_;
    if (!system_.has_skew_part()) return without_neutral_part(std::move(x));
    return without_neutral_part(solve_skew(x, 1.0));
}

/// Compute (S + sign W)^-1 b from S^-1 b, where S is the symmetric part and W the skew part.
Eigen::VectorXd Newton::solve_skew(const Eigen::VectorXd& symmetric_solution, double sign) const {
    return solve_near_identity(
        [this, sign](const Eigen::VectorXd& v) {
            Eigen::VectorXd y = sign * system_.skew_product(v);
            factors_.solve(y, options_.control);
            return y;
        },
        symmetric_solution);
}

Eigen::MatrixXd Newton::tangent_product(const Eigen::MatrixXd& x, double sign) const {
    Eigen::MatrixXd result(x.rows(), x.cols());
    for (Eigen::Index c = 0; c < x.cols(); ++c) {
        const Eigen::VectorXd column = x.col(c);
        Eigen::VectorXd y = Eigen::VectorXd::Zero(x.rows());
        if (system_.has_skew_part()) y = sign * system_.skew_product(column);
        sparse::add_product(unknowns_.layout(), system_.tangent(), column, y);
        result.col(c) = y;
    }
    return result;
}

Eigen::MatrixXd Newton::solve_plainly(Eigen::MatrixXd right_sides) const {
    factors_.solve(right_sides, options_.control);
    return right_sides;
}

std::optional<Eigen::MatrixXd> Newton::solve_refined(const Eigen::MatrixXd& right_sides, Side side) {
    const double sign = side == Side::Tangent ? 1.0 : -1.0;
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(right_sides.rows(), right_sides.cols());
    Eigen::MatrixXd step = right_sides;
    for (std::optional<double> last;;) {
        options_.control.check();
        factors_.solve(step, options_.control);
        double share = 0.0;  // largest ratio of a step to its solution
        for (Eigen::Index c = 0; c < x.cols(); ++c) {
            if (system_.has_skew_part()) step.col(c) = solve_skew(step.col(c), sign);
            x.col(c) += step.col(c);
            const double whole = unknowns_.size_of(x.col(c));
            if (whole > 0.0) share = std::max(share, unknowns_.size_of(step.col(c)) / whole);
        }
        if (share <= kRefinedStep) return x;
        if (last && !(share <= kSlowRefinement * *last)) {
            if (share <= kLeastRefined) return x;  // rounding
            return std::nullopt;
        }
        last = share;
        step = right_sides - tangent_product(x, sign);
    }
}

bool Newton::is_converged(const Configuration& configuration, const Eigen::VectorXd& last_step) const {
    if (system_.relative_residual() <= options_.relative_residual) return true;
    if (system_.is_rounding() &&
        unknowns_.largest_component(unknowns_.step_between(unknowns_.rest(), configuration)) <= kLinearReach)
        return true;
    return last_step.size() > 0 && system_.relative_residual() <= kResidualFloor &&
           unknowns_.largest_component(last_step) <= kNegligibleStep;
}

/// Make a step with the factors of the configuration. Returns Converged if the step was made.
Termination Newton::make_step(Eigen::VectorXd& step, Configuration& configuration) {
    step = solve_tangent(system_.unbalanced());
    const double rotation = unknowns_.largest_rotation(step);
    if (!std::isfinite(rotation)) return Termination::Diverged;
    if (rotation > options_.largest_rotation_step) step *= options_.largest_rotation_step / rotation;
    unknowns_.move(step, configuration);
    return Termination::Converged;
}

Termination Newton::solve(double load_factor, Configuration& configuration) {
    Eigen::VectorXd step;
    for (int iteration = 0;; ++iteration) {
        system_.evaluate(configuration, load_factor);
        if (!std::isfinite(system_.relative_residual())) return Termination::Diverged;
        if (is_converged(configuration, step)) return Termination::Converged;
        if (iteration == options_.iterations_per_step) return Termination::IterationsSpent;
        if (factorize().zero_pivot >= 0) return Termination::Diverged;
        if (make_step(step, configuration) != Termination::Converged) return Termination::Diverged;
    }
}

std::optional<sparse::Ldlt::Outcome> Newton::solve_and_factorize(double load_factor,
                                                                 const Eigen::VectorXd& way,
                                                                 Configuration& configuration) {
    const double whole = unknowns_.size_of(way);
    Eigen::VectorXd step;
    sparse::Ldlt::Outcome outcome;
    bool has_factors = false;
    for (int iteration = 0;; ++iteration) {
        system_.evaluate(configuration, load_factor, has_factors ? Demand::Force : Demand::Tangent);
        if (!std::isfinite(system_.relative_residual())) return {};
        const bool is_there = is_converged(configuration, step);
        if (is_there && has_factors) return outcome;
        if (has_factors) system_.evaluate(configuration, load_factor);
        outcome = factorize();
        if (outcome.zero_pivot >= 0) return {};
        if (is_there) return outcome;
        if (iteration == options_.iterations_per_step) return {};
        const double residual = system_.relative_residual();
        if (make_step(step, configuration) != Termination::Converged) return {};
        // A Newton step squares the residual.
        has_factors = residual * residual <= options_.relative_residual && !outcome.has_weak_pivot &&
                      unknowns_.largest_component(step) <= kNegligibleMove &&
                      unknowns_.size_of(step) <= kNegligibleShare * whole;
    }
}

}  // namespace fretwork::mechanics::nonlinear
