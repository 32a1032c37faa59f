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

/// |a| with its kink rounded.
double smooth_norm(const Vector3d& a, double rounding) {
    return std::max(std::sqrt(a.squaredNorm() + rounding * rounding), 1e-300);
}

}  // namespace

/// One interface node in one sample: its two smoothed norms as functions of the six components of its unit
/// displacement.
struct Objective::NodeTerm {
    NodeTerm(const Sample& sample, std::size_t node, const NodeMotion& motion,
             const std::array<double, 2>& rounding)
        : NodeTerm(sample, motion, motion.missed_translation(sample, node),
                   geometry::logarithm(motion.missed_rotation(sample, node)), rounding) {}

    double exact;                 ///< the node's part of e
    double smoothed_translation;  ///< the translation's part with its norm smoothed
    double smoothed_rotation;     ///< the rotation's part with its norm smoothed
    Vector3d translation_slope;   ///< derivative of `smoothed_translation`
    Vector3d rotation_slope;      ///< derivative of `smoothed_rotation`
    double across;                ///< the factor of J_r^T J_r across the axis of rotation; 1 along it

    [[nodiscard]] double smoothed() const { return smoothed_translation + smoothed_rotation; }

  private:
    // Let m be the magnitude, v = m u the model's rotation vector, a the missed rotation vector, J the right
    // Jacobian. A change du changes a by J(a)^-1 J(v) m du. J(a)^-1 leaves a unchanged, so the slope of |a|
    // is exact without this factor. The curvature takes it as the identity.
    NodeTerm(const Sample& sample, const NodeMotion& motion, const Vector3d& difference,
             const Vector3d& angle, const std::array<double, 2>& rounding)
        : exact(sample.translation_factor * difference.norm() + sample.rotation_factor * angle.norm()),
          across(motion.squared_rate_across()) {
        const double translation = smooth_norm(difference, rounding[0]);
        const double rotation = smooth_norm(angle, rounding[1]);
        smoothed_translation = sample.translation_factor * translation;
        smoothed_rotation = sample.rotation_factor * rotation;
        translation_slope = sample.translation_factor * sample.magnitude / translation * difference;
        rotation_slope = sample.rotation_factor * sample.magnitude / rotation * motion.pull_back(angle);
    }
};

/// The sum of second derivatives of a node's smoothed norms over the magnitudes of a scenario.
///
/// The second derivative of a norm's part p = f |a| is (f^2 A^T A - s s^T) / p, where A is the derivative of
/// a and s the slope of p. For translations A = m I. For rotations A = m J_r, and J_r^T J_r is the same
/// multiple of the identity across the axis of rotation at all nodes' magnitudes, and the identity along the
/// axis.
class Objective::NodeBend {
  public:
    /// @param factor  derivative of E with respect to the node's part of e
    void add(double factor, const Sample& sample, const NodeTerm& term) {
        const double translation = factor / term.smoothed_translation;
        const double rotation = factor / term.smoothed_rotation;
        even_ += translation * square(sample.translation_factor * sample.magnitude);
        add_square(-translation, term.translation_slope, translation_);
        const double along = rotation * square(sample.rotation_factor * sample.magnitude);
        across_ += term.across * along;
        along_ += (1.0 - term.across) * along;
        add_square(-rotation, term.rotation_slope, rotation_);
    }
    [[nodiscard]] Matrix3d translation() const { return full(translation_, even_); }
    /// @param axis  axis of the node's rotation
    [[nodiscard]] Matrix3d rotation(const Vector3d& axis) const {
        return full(rotation_, across_) + along_ * axis * axis.transpose();
    }

  private:
    /// The upper triangle of a symmetric matrix: xx, yy, zz, xy, xz, yz.
    using Triangle = std::array<double, 6>;

    static double square(double x) { return x * x; }
    static void add_square(double factor, const Vector3d& v, Triangle& sum) {
        const Vector3d scaled = factor * v;
        sum[0] += scaled.x() * v.x();
        sum[1] += scaled.y() * v.y();
        sum[2] += scaled.z() * v.z();
        sum[3] += scaled.x() * v.y();
        sum[4] += scaled.x() * v.z();
        sum[5] += scaled.y() * v.z();
    }
    static Matrix3d full(const Triangle& t, double diagonal) {
        return Matrix3d{
            {t[0] + diagonal, t[3], t[4]}, {t[3], t[1] + diagonal, t[5]}, {t[4], t[5], t[2] + diagonal}};
    }

    double even_ = 0.0;    ///< multiple of the identity in the translation's part
    double across_ = 0.0;  ///< multiple of the identity in the rotation's part
    double along_ = 0.0;   ///< multiple of axis axis^T in the rotation's part
    Triangle translation_{};
    Triangle rotation_{};
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
            smoothed_ += term.smoothed();
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
                const Vector3d turn = model_.displacements[s].row(at / 6).tail<3>();
                bent.middleRows<3>(at) = bend.translation().lazyProduct(rates.middleRows<3>(at));
                bent.middleRows<3>(at + 3) =
                    bend.rotation(turn.stableNormalized()).lazyProduct(rates.middleRows<3>(at + 3));
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
            slopes_.block<3, 1>(at, row) = root * term.translation_slope;
            slopes_.block<3, 1>(at + 3, row) = root * term.rotation_slope;
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
            bends[node].add(factor, sample, terms_.nodes()[node]);
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
            for (std::size_t node = 0; node < motions.size(); ++node) {
                auto row = slopes.row(static_cast<Eigen::Index>(node));
                row.head<3>() += factor * terms.nodes()[node].translation_slope.transpose();
                row.tail<3>() += factor * terms.nodes()[node].rotation_slope.transpose();
            }
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
