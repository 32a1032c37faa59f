// SPDX-License-Identifier: GPL-3.0-or-later
// The derivatives of E with respect to the displacements of a linear model, and with respect to the model's
// parameters.
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/reduction/detail/node_motion.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::reduction {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// |a| with its kink rounded, and its first and second derivatives.
struct SmoothNorm {
    SmoothNorm(const Vector3d& a, double rounding)
        : value(std::max(std::sqrt(a.squaredNorm() + rounding * rounding), 1e-300)), slope(a / value) {}
    double value;
    Vector3d slope;  ///< derivative with respect to a
    /// The second derivative with respect to a, positive semidefinite.
    [[nodiscard]] Matrix3d bend() const { return (Matrix3d::Identity() - slope * slope.transpose()) / value; }
};

}  // namespace

/// One interface node in one sample: its two smoothed norms as functions of the six components of its unit
/// displacement.
struct Objective::NodeTerm {
    NodeTerm(const Sample& sample, std::size_t node, const NodeMotion& motion,
             const std::array<double, 2>& rounding)
        : NodeTerm(sample, motion, motion.missed_translation(sample, node),
                   geometry::logarithm(motion.missed_rotation(sample, node)), rounding) {}

    double exact;                       ///< the node's part of e
    double smoothed;                    ///< the same with smoothed norms
    Eigen::Matrix<double, 6, 1> slope;  ///< derivative of the smoothed part

    /// Second derivatives of the smoothed part with respect to the translation.
    [[nodiscard]] Matrix3d translation_bend(const Sample& sample) const {
        return sample.translation_factor * sample.magnitude * sample.magnitude * translation_.bend();
    }
    [[nodiscard]] Matrix3d rotation_bend(const Sample& sample) const {
        return sample.rotation_factor * rate_.transpose() * rotation_.bend() * rate_;
    }

  private:
    NodeTerm(const Sample& sample, const NodeMotion& motion, const Vector3d& difference,
             const Vector3d& angle, const std::array<double, 2>& rounding)
        : exact(sample.translation_factor * difference.norm() + sample.rotation_factor * angle.norm()),
          translation_(difference, rounding[0]),
          rotation_(angle, rounding[1]),
          rate_(sample.magnitude * motion.right_jacobian()) {
        smoothed = sample.translation_factor * translation_.value + sample.rotation_factor * rotation_.value;
        slope << sample.translation_factor * sample.magnitude * translation_.slope,
            sample.rotation_factor * rate_.transpose() * rotation_.slope;
    }

    SmoothNorm translation_;
    SmoothNorm rotation_;
    // Let m be the magnitude, v = m u the model's rotation vector, a the missed rotation vector, J the right
    // Jacobian. A change du changes a by J(a)^-1 J(v) m du. J(a)^-1 leaves a unchanged, so the slope of |a|
    // is exact without this factor. The curvature takes it as the identity.
    Matrix3d rate_;
};

/// All nodes in one sample.
class Objective::SampleTerms {
  public:
    SampleTerms(const ErrorMetric& metric, double smoothing) : metric_(metric), smoothing_(smoothing) {}

    void set(const Sample& sample, std::span<const NodeMotion> motions) {
        const std::array<double, 2> rounding = rounding_of(sample);
        nodes_.clear();
        exact_ = 0.0;
        smoothed_ = 0.0;
        for (std::size_t node = 0; node < motions.size(); ++node) {
            const NodeTerm& term = nodes_.emplace_back(sample, node, motions[node], rounding);
            exact_ += term.exact;
            smoothed_ += term.smoothed;
        }
    }
    [[nodiscard]] std::span<const NodeTerm> nodes() const { return nodes_; }
    [[nodiscard]] double exact() const { return exact_; }        ///< e
    [[nodiscard]] double smoothed() const { return smoothed_; }  ///< e with smoothed norms

  private:
    [[nodiscard]] std::array<double, 2> rounding_of(const Sample& sample) const {
        const double share = smoothing_ / static_cast<double>(sample.targets.size());
        return {share * metric_.translation_weight / sample.translation_factor,
                share * metric_.rotation_weight / sample.rotation_factor};
    }

    const ErrorMetric& metric_;
    double smoothing_;
    std::vector<NodeTerm> nodes_;
    double exact_ = 0.0;
    double smoothed_ = 0.0;
};

/// Sums up derivatives over the samples. Second derivatives of one node under one scenario are summed over
/// the magnitudes first, and then multiplied by the model's derivatives, which all magnitudes share.
class Objective::Differentiation {
  public:
    /// The choice whether second derivatives are computed, too.
    enum class Bends { LeftOut, Summed };

    Differentiation(const Objective& owner, const UnitDisplacementsAndDerivatives& model, double smoothing,
                    Bends bends)
        : owner_(owner), model_(model), terms_(owner.metric_, smoothing), wanted_(bends) {
        const Eigen::Index parameters = model.derivatives.front().cols();
        jacobian.resize(static_cast<Eigen::Index>(owner.samples_.size()), parameters);
        errors.resize(jacobian.rows());
        bends_.resize(model.displacements.size());
        for (std::size_t s = 0; s < bends_.size(); ++s) {
            bends_[s].resize(model.displacements[s].rows());
        }
        slopes_.resize(6 * model.displacements.front().rows(), jacobian.rows());
        for (std::size_t s = 0; s < bends_.size(); ++s) add_scenario(s);
    }

    /// The sum over the nodes of the curvature that comes from the norms.
    [[nodiscard]] Eigen::MatrixXd norm_curvature() const {
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(jacobian.cols(), jacobian.cols());
        Eigen::MatrixXd bent;
        for (std::size_t s = 0; s < bends_.size(); ++s) {
            const Eigen::MatrixXd& rates = model_.derivatives[s];
            bent.resize(rates.rows(), rates.cols());
            for (std::size_t node = 0; node < bends_[s].size(); ++node) {
                const auto at = static_cast<Eigen::Index>(6 * node);
                const NodeBend& bend = bends_[s][node];
                bent.middleRows<3>(at) = bend.translation.lazyProduct(rates.middleRows<3>(at));
                bent.middleRows<3>(at + 3) = bend.rotation.lazyProduct(rates.middleRows<3>(at + 3));
            }
            sum.noalias() += rates.transpose() * bent;
        }
        return sum;
    }

    double objective = 0.0;    ///< E itself
    double value = 0.0;        ///< E with smoothed norms
    Eigen::VectorXd errors;    ///< sqrt(w) e, smoothed, one for each sample
    Eigen::MatrixXd jacobian;  ///< derivatives of `errors`

  private:
    struct NodeBend {
        Matrix3d translation = Matrix3d::Zero();
        Matrix3d rotation = Matrix3d::Zero();
    };

    void add_scenario(std::size_t s) {
        auto motions = NodeMotion::of_all(model_.displacements[s]);
        const auto samples = owner_.samples_of(s);
        const auto first = static_cast<Eigen::Index>(owner_.first_samples_[s]);
        const auto count = static_cast<Eigen::Index>(samples.size());
        for (Eigen::Index k = 0; k < count; ++k) {
            for (NodeMotion& motion : motions) motion.advance_to(samples[k]);
            terms_.set(samples[k], motions);
            add_sample(samples[k], first + k);
            if (wanted_ == Bends::Summed) add_bends(samples[k], bends_[s], errors[first + k]);
        }
        jacobian.middleRows(first, count).noalias() =
            slopes_.middleCols(first, count).transpose() * model_.derivatives[s];
    }

    void add_sample(const Sample& sample, Eigen::Index row) {
        const double root = std::sqrt(sample.weight);
        Eigen::Index at = 0;
        for (const NodeTerm& term : terms_.nodes()) {
            slopes_.block<6, 1>(at, row) = root * term.slope;
            at += 6;
        }
        objective += sample.weight * terms_.exact() * terms_.exact();
        value += sample.weight * terms_.smoothed() * terms_.smoothed();
        errors[row] = root * terms_.smoothed();
    }

    /// @param error  sqrt(w) e of the sample
    void add_bends(const Sample& sample, std::vector<NodeBend>& bends, double error) {
        const double factor = 2.0 * std::sqrt(sample.weight) * error;
        for (std::size_t node = 0; node < bends.size(); ++node) {
            bends[node].translation += factor * terms_.nodes()[node].translation_bend(sample);
            bends[node].rotation += factor * terms_.nodes()[node].rotation_bend(sample);
        }
    }

    const Objective& owner_;
    const UnitDisplacementsAndDerivatives& model_;
    SampleTerms terms_;
    Bends wanted_;
    std::vector<std::vector<NodeBend>> bends_;
    /// Derivatives of sqrt(w) e with respect to the unit displacements, one column for each sample.
    Eigen::MatrixXd slopes_;
};

DisplacementGradient Objective::gradient(const UnitDisplacements& model, double smoothing) const {
    return smoothing > 0.0 ? smoothed_gradient(model, smoothing) : exact_gradient(model);
}

DisplacementGradient Objective::smoothed_gradient(const UnitDisplacements& model, double smoothing) const {
    DisplacementGradient result{0.0, 0.0, {}};
    SampleTerms terms(metric_, smoothing);
    for (std::size_t s = 0; s < model.size(); ++s) {
        auto motions = NodeMotion::of_all(model[s]);
        auto& slopes = result.slopes.emplace_back(mechanics::NodeValues::Zero(model[s].rows(), 6));
        for (const Sample& sample : samples_of(s)) {
            for (NodeMotion& motion : motions) motion.advance_to(sample);
            terms.set(sample, motions);
            result.objective += sample.weight * terms.exact() * terms.exact();
            result.value += sample.weight * terms.smoothed() * terms.smoothed();
            const double factor = 2.0 * sample.weight * terms.smoothed();
            for (std::size_t node = 0; node < motions.size(); ++node)
                slopes.row(static_cast<Eigen::Index>(node)) += factor * terms.nodes()[node].slope.transpose();
        }
    }
    return result;
}

/// The gradient without smoothing. The slope of a norm is then a direction, so the angles of single nodes are
/// not needed, only their sum.
DisplacementGradient Objective::exact_gradient(const UnitDisplacements& model) const {
    DisplacementGradient result{0.0, 0.0, {}};
    std::vector<Eigen::Matrix<double, 6, 1>> sample_slopes;
    for (std::size_t s = 0; s < model.size(); ++s) {
        auto motions = NodeMotion::of_all(model[s]);
        sample_slopes.resize(motions.size());
        auto& slopes = result.slopes.emplace_back(mechanics::NodeValues::Zero(model[s].rows(), 6));
        for (const Sample& sample : samples_of(s)) {
            for (NodeMotion& motion : motions) motion.advance_to(sample);
            const double error = differentiated_error(sample, motions, sample_slopes);
            result.objective += sample.weight * error * error;
            const double factor = 2.0 * sample.weight * error;
            for (std::size_t node = 0; node < motions.size(); ++node)
                slopes.row(static_cast<Eigen::Index>(node)) += factor * sample_slopes[node].transpose();
        }
    }
    result.value = result.objective;
    return result;
}

double Objective::differentiated_error(const Sample& sample, std::span<const NodeMotion> motions,
                                       std::span<Eigen::Matrix<double, 6, 1>> slopes) {
    constexpr double kTiny = 1e-300;  // at a kink, 0 is taken as the slope, one of many valid slopes
    double translations = 0.0;
    detail::AngleSum half_rotations;
    for (std::size_t node = 0; node < motions.size(); ++node) {
        const Vector3d difference = motions[node].missed_translation(sample, node);
        const Eigen::Quaterniond missed = motions[node].missed_rotation(sample, node);
        const double length = difference.norm();
        const double sine = missed.vec().norm();
        const double shorter_way = missed.w() < 0.0 ? -1.0 : 1.0;
        translations += length;
        half_rotations.add(sine, std::abs(missed.w()));
        slopes[node] << sample.translation_factor * sample.magnitude / std::max(length, kTiny) * difference,
            sample.rotation_factor * sample.magnitude * shorter_way / std::max(sine, kTiny) *
                motions[node].pull_back(missed.vec());
    }
    return sample.translation_factor * translations + sample.rotation_factor * 2.0 * half_rotations.value();
}

optimization::CurvatureEvaluation Objective::curvature(const UnitDisplacementsAndDerivatives& model,
                                                       double smoothing) const {
    const Differentiation d(*this, model, smoothing, Differentiation::Bends::Summed);
    return {d.objective, d.value, 2.0 * d.jacobian.transpose() * d.errors,
            2.0 * d.jacobian.transpose() * d.jacobian + d.norm_curvature()};
}

optimization::ResidualEvaluation Objective::residuals(const UnitDisplacementsAndDerivatives& model,
                                                      double smoothing) const {
    const Differentiation d(*this, model, smoothing, Differentiation::Bends::LeftOut);
    return {d.objective, d.errors, d.jacobian};
}

}  // namespace fretwork::reduction
