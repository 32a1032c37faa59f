// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/problem.hpp>

namespace fretwork::optimization {
namespace {

[[noreturn]] void refuse(const Problem& problem, Evaluation kind) {
    throw base::NumericalError("problem '" + problem.name() + "' offers no " +
                               std::string(evaluation_name(kind)));
}

}  // namespace

std::string_view evaluation_name(Evaluation kind) {
    switch (kind) {
        case Evaluation::Value:
            return "value";
        case Evaluation::Gradient:
            return "gradient";
        case Evaluation::Residuals:
            return "residuals";
        case Evaluation::Curvature:
            return "curvature";
    }
    return "unknown";
}

bool Bounds::contain(const Eigen::VectorXd& point) const {
    return point.size() == lower.size() && (point.array() >= lower.array()).all() &&
           (point.array() <= upper.array()).all();
}

Eigen::VectorXd Bounds::clamp(const Eigen::VectorXd& point) const {
    return point.cwiseMax(lower).cwiseMin(upper);
}

Eigen::VectorXd Bounds::at_shares(const Eigen::VectorXd& shares) const {
    return clamp(lower + shares.cwiseProduct(upper - lower));
}

void Bounds::validate() const {
    if (lower.size() != upper.size() || lower.size() == 0) {
        throw base::InputError(
            "bounds: lower and upper bounds must be equal in number, at least one of each");
    }
    for (Eigen::Index i = 0; i < lower.size(); ++i) {
        if (std::isfinite(lower[i]) && std::isfinite(upper[i]) && lower[i] < upper[i]) continue;
        throw base::InputError("bounds", "/" + std::to_string(i),
                               "lower " + base::format_number(lower[i]) + " and upper " +
                                   base::format_number(upper[i]) + " must be finite, lower < upper");
    }
}

GradientEvaluation Problem::gradient(const Eigen::VectorXd&, double) const {
    refuse(*this, Evaluation::Gradient);
}

ResidualEvaluation Problem::residuals(const Eigen::VectorXd&, double) const {
    refuse(*this, Evaluation::Residuals);
}

CurvatureEvaluation Problem::curvature(const Eigen::VectorXd&, double) const {
    refuse(*this, Evaluation::Curvature);
}

}  // namespace fretwork::optimization
