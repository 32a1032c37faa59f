// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <string>
#include <string_view>

namespace fretwork::optimization {

/// The kinds of evaluation that a problem may offer.
enum class Evaluation {
    Value,      ///< the objective
    Gradient,   ///< the objective and its gradient
    Residuals,  ///< the residuals and their Jacobian matrix
    Curvature   ///< the objective, its gradient and a generalized Gauss-Newton matrix
};
/// The word for a kind of evaluation in tables.
std::string_view evaluation_name(Evaluation kind);

/// Bounds of the variables: lower <= x <= upper, component by component.
struct Bounds {
    Eigen::VectorXd lower;  ///< lower bound of each variable
    Eigen::VectorXd upper;  ///< upper bound of each variable
    /// The number of variables.
    [[nodiscard]] int dimension() const { return static_cast<int>(lower.size()); }
    /// True if the point lies within the bounds; false for a point with NaN.
    [[nodiscard]] bool contain(const Eigen::VectorXd& point) const;
    /// The point within the bounds that is nearest to `point`.
    [[nodiscard]] Eigen::VectorXd clamp(const Eigen::VectorXd& point) const;
    /// The point lower + shares (upper - lower), component by component, clamped to the bounds.
    [[nodiscard]] Eigen::VectorXd at_shares(const Eigen::VectorXd& shares) const;
    /// Throws InputError unless there is a variable, each has two bounds, and all bounds are finite with
    /// lower < upper.
    void validate() const;
};

/// The objective and a gradient. In every evaluation with derivatives, `value` and the derivatives belong to
/// the smoothed objective: `smoothing` rounds the kinks of the objective. With smoothing 0, value =
/// objective.
struct GradientEvaluation {
    double objective = 0.0;    ///< objective without smoothing
    double value = 0.0;        ///< smoothed objective, which is differentiated
    Eigen::VectorXd gradient;  ///< derivatives of `value` with respect to the variables
};

/// Residuals and their Jacobian. The smoothed objective is the squared norm of the residuals.
struct ResidualEvaluation {
    double objective = 0.0;     ///< objective without smoothing
    Eigen::VectorXd residuals;  ///< residuals; the sum of their squares is the smoothed objective
    Eigen::MatrixXd jacobian;   ///< derivatives, one row for each residual
};

/// Gradient and curvature. `curvature` is a generalized Gauss-Newton matrix: positive semidefinite, and equal
/// to the Hessian without the terms that contain second derivatives of the inner model. If the problem also
/// offers residuals, the matrix is not smaller than 2 J^T J, where J is their Jacobian.
struct CurvatureEvaluation {
    double objective = 0.0;     ///< objective without smoothing
    double value = 0.0;         ///< smoothed objective, which is differentiated
    Eigen::VectorXd gradient;   ///< derivatives of `value` with respect to the variables
    Eigen::MatrixXd curvature;  ///< curvature matrix, symmetric and positive semidefinite
};

/// A function to be minimized inside bounds. A problem states the kinds of evaluation that it offers, and the
/// cost of each kind in its own unit. An Evaluator adds up the cost. Evaluations are pure: thread-safe and
/// repeatable.
class Problem {
  public:
    virtual ~Problem() = default;

    /// The name of the problem in tables and messages.
    [[nodiscard]] virtual std::string name() const = 0;
    /// The bounds within which the problem is defined.
    [[nodiscard]] virtual const Bounds& bounds() const = 0;
    /// True if the problem offers evaluations of this kind.
    [[nodiscard]] virtual bool offers(Evaluation kind) const { return kind == Evaluation::Value; }
    /// The cost of one evaluation of a kind, in cost_unit().
    [[nodiscard]] virtual long cost(Evaluation) const { return 1; }
    /// The unit of cost, a noun in the plural.
    [[nodiscard]] virtual std::string cost_unit() const { return "evaluations"; }
    /// True if the objective has kinks that `smoothing` > 0 rounds. A problem without kinks ignores
    /// smoothing.
    [[nodiscard]] virtual bool has_kinks() const { return false; }
    /// True if a variable is the natural logarithm of the quantity that is fitted. A method can then move in
    /// the quantity itself, which shows how sensitive the method is to scales.
    [[nodiscard]] virtual bool is_logarithm(int /*variable*/) const { return false; }

    /// The objective at a point within the bounds.
    [[nodiscard]] virtual double value(const Eigen::VectorXd& point) const = 0;
    /// The objective and a gradient at a point. Throws NumericalError if the problem does not offer
    /// gradients.
    [[nodiscard]] virtual GradientEvaluation gradient(const Eigen::VectorXd& point, double smoothing) const;
    /// The residuals and their Jacobian at a point. Throws NumericalError if the problem does not offer
    /// residuals.
    [[nodiscard]] virtual ResidualEvaluation residuals(const Eigen::VectorXd& point, double smoothing) const;
    /// The gradient and the curvature at a point. Throws NumericalError if the problem does not offer
    /// curvatures.
    [[nodiscard]] virtual CurvatureEvaluation curvature(const Eigen::VectorXd& point, double smoothing) const;
};

}  // namespace fretwork::optimization
