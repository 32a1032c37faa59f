// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <string>
#include <string_view>

namespace fretwork::optimization {

/// The kinds of evaluation that a problem may offer.
enum class Evaluation { Value, Gradient, Residuals, Curvature };
std::string_view evaluation_name(Evaluation kind);

/// lower <= x <= upper, component by component.
struct Bounds {
    Eigen::VectorXd lower;
    Eigen::VectorXd upper;
    [[nodiscard]] int dimension() const { return static_cast<int>(lower.size()); }
    /// False for a point with NaN, too.
    [[nodiscard]] bool contain(const Eigen::VectorXd& point) const;
    [[nodiscard]] Eigen::VectorXd clamp(const Eigen::VectorXd& point) const;
    /// The point at these shares of the way from lower to upper.
    [[nodiscard]] Eigen::VectorXd at_shares(const Eigen::VectorXd& shares) const;
    /// Throws InputError unless all bounds are finite and lower < upper.
    void validate() const;
};

/// Each evaluation with derivatives gives the objective itself, too, and the value of what is differentiated,
/// which is the objective with its kinks rounded off by `smoothing` (0: the objective).
struct GradientEvaluation {
    double objective = 0.0;
    double value = 0.0;
    Eigen::VectorXd gradient;
};

/// The value is the squared norm of the residuals.
struct ResidualEvaluation {
    double objective = 0.0;
    Eigen::VectorXd residuals;
    Eigen::MatrixXd jacobian;  ///< one row a residual
};

/// `curvature` is a generalized Gauss-Newton matrix: positive semidefinite, and equal to the Hessian up to
/// terms with second derivatives of the model inside. Where the problem offers residuals as well, it is not
/// smaller than 2 J^T J.
struct CurvatureEvaluation {
    double objective = 0.0;
    double value = 0.0;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd curvature;
};

/// A function to be minimized inside bounds. It says which evaluations it offers and what each costs in its
/// own unit; it counts nothing itself (see Evaluator). Evaluations are pure: thread-safe and repeatable.
class Problem {
  public:
    virtual ~Problem() = default;

    [[nodiscard]] virtual std::string name() const = 0;
    [[nodiscard]] virtual const Bounds& bounds() const = 0;
    [[nodiscard]] virtual bool offers(Evaluation kind) const { return kind == Evaluation::Value; }
    [[nodiscard]] virtual long cost(Evaluation) const { return 1; }
    [[nodiscard]] virtual std::string cost_unit() const { return "evaluations"; }
    /// True if the objective has kinks which `smoothing` > 0 rounds off. A smooth problem ignores smoothing.
    [[nodiscard]] virtual bool has_kinks() const { return false; }
    /// True if this variable is the natural logarithm of the quantity that is fitted. Methods that
    /// are sensitive to scales can then move in the quantity itself, to show what that does.
    [[nodiscard]] virtual bool is_logarithm(int /*variable*/) const { return false; }

    [[nodiscard]] virtual double value(const Eigen::VectorXd& point) const = 0;
    /// Only of problems that offer it; the others throw NumericalError.
    [[nodiscard]] virtual GradientEvaluation gradient(const Eigen::VectorXd& point, double smoothing) const;
    [[nodiscard]] virtual ResidualEvaluation residuals(const Eigen::VectorXd& point, double smoothing) const;
    [[nodiscard]] virtual CurvatureEvaluation curvature(const Eigen::VectorXd& point, double smoothing) const;
};

}  // namespace fretwork::optimization
