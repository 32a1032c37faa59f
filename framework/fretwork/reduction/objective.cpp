// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/reduction/detail/rotation.hpp>
#include <fretwork/reduction/objective.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretwork::reduction {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Which samples of a scenario the sample policy leaves in.
std::vector<const Response::Sample*> used_samples(const Response& response, const Setting& setting) {
    std::vector<const Response::Sample*> used;
    for (const Response::Sample& sample : response.samples) {
        // A path that has lost its stability is not what a specimen follows, even where it is stable again.
        if (setting.sample_policy == SamplePolicy::Stable && sample.converged && !sample.stable) break;
        if (sample.converged) used.push_back(&sample);
    }
    return used;
}

void check_fit(const std::vector<Response>& responses, const Setting& setting) {
    const bool as_many = responses.size() == setting.scenarios.size();
    for (std::size_t i = 0; i < setting.scenarios.size(); ++i) {
        if (as_many && responses[i].scenario == setting.scenarios[i].name) continue;
        throw base::InputError("the responses lack scenario '" + setting.scenarios[i].name +
                               "' in its place");
    }
    for (const Response& response : responses) {
        for (const Response::Sample& sample : response.samples) {
            if (sample.displacements.rows() == setting.sides) continue;
            throw base::InputError("a response to '" + response.scenario + "' has " +
                                   std::to_string(sample.displacements.rows()) + " interface nodes, not " +
                                   std::to_string(setting.sides));
        }
    }
}

/// |a| with its kink rounded off, and what that does to first and second derivatives.
struct SmoothNorm {
    double value;
    Vector3d slope;  ///< by a
    Matrix3d bend;   ///< by a, twice: positive semidefinite
};

SmoothNorm smooth_norm(const Vector3d& a, double rounding) {
    const double value = std::max(std::sqrt(a.squaredNorm() + rounding * rounding), 1e-300);
    const Vector3d slope = a / value;
    return {value, slope, (Matrix3d::Identity() - slope * slope.transpose()) / value};
}

}  // namespace

/// How a node moves in one scenario of a linear model, from magnitude to magnitude.
class Objective::NodeMotion {
  public:
    template <class Row>
    explicit NodeMotion(const Row& unit)
        : unit_translation_(unit.template head<3>()), rotation_(unit.template tail<3>()) {}

    void advance_to(const Sample& sample) {
        if (sample.is_other_step) rotation_.set_step(sample.step);
        rotation_.advance();
    }
    [[nodiscard]] Vector3d missed_translation(const Sample& sample, std::size_t node) const {
        return sample.magnitude * unit_translation_ - sample.targets[node].translation;
    }
    [[nodiscard]] Eigen::Quaterniond missed_rotation(const Sample& sample, std::size_t node) const {
        return sample.targets[node].inverse_rotation * rotation_.rotation();
    }
    [[nodiscard]] Matrix3d right_jacobian() const { return rotation_.right_jacobian(); }

    static std::vector<NodeMotion> of_all(const mechanics::NodeValues& unit) {
        return {unit.rowwise().begin(), unit.rowwise().end()};
    }

  private:
    Vector3d unit_translation_;
    detail::GrowingRotation rotation_;
};

Objective::Objective(const std::vector<Response>& responses, const Setting& setting,
                     const ErrorMetric& metric)
    : metric_(metric) {
    check_fit(responses, setting);
    for (std::size_t s = 0; s < responses.size(); ++s) {
        first_samples_.push_back(samples_.size());
        for (const Response::Sample* sample : used_samples(responses[s], setting)) {
            samples_.push_back(make_sample(*sample, setting.scenarios[s].weight, metric));
        }
        set_steps(std::span(samples_).subspan(first_samples_.back()));
    }
    first_samples_.push_back(samples_.size());
}

/// Equal steps differ by the rounding of the magnitudes alone.
void Objective::set_steps(std::span<Sample> samples) {
    constexpr double kRoundOff = 4.0 * std::numeric_limits<double>::epsilon();
    double magnitude = 0.0;
    double step = 0.0;
    for (Sample& sample : samples) {
        sample.step = sample.magnitude - magnitude;
        sample.is_other_step = std::abs(sample.step - step) > kRoundOff * sample.magnitude;
        if (sample.is_other_step) step = sample.step;
        magnitude = sample.magnitude;
    }
}

Objective::Sample Objective::make_sample(const Response::Sample& sample, double weight,
                                         const ErrorMetric& metric) {
    Sample result{.place = static_cast<std::size_t>(sample.step) - 1,
                  .magnitude = sample.magnitude,
                  .step = sample.magnitude,
                  .is_other_step = true,
                  .weight = weight,
                  .translation_factor = 0.0,
                  .rotation_factor = 0.0,
                  .targets = {}};
    double translations = 0.0;
    double rotations = 0.0;
    for (const auto& row : sample.displacements.rowwise()) {
        const Vector3d translation = row.head<3>();
        const Eigen::Quaterniond rotation = detail::rotation_of(row.tail<3>());
        translations += translation.norm();
        rotations += detail::rotation_vector_of(rotation).norm();
        result.targets.push_back({translation, rotation.conjugate()});
    }
    result.translation_factor =
        metric.translation_weight / std::max(translations, metric.smallest_translation);
    result.rotation_factor = metric.rotation_weight / std::max(rotations, metric.smallest_rotation);
    return result;
}

double Objective::sample_error(const Sample& sample, std::span<const NodeMotion> motions) {
    double translations = 0.0;
    detail::AngleSum half_rotations;
    for (std::size_t node = 0; node < motions.size(); ++node) {
        translations += motions[node].missed_translation(sample, node).norm();
        const Eigen::Quaterniond missed = motions[node].missed_rotation(sample, node);
        half_rotations.add(missed.vec().norm(), std::abs(missed.w()));
    }
    return sample.translation_factor * translations + sample.rotation_factor * 2.0 * half_rotations.value();
}

std::span<const Objective::Sample> Objective::samples_of(std::size_t scenario) const {
    const std::size_t first = first_samples_[scenario];
    return std::span(samples_).subspan(first, first_samples_[scenario + 1] - first);
}

double Objective::scenario_error(std::size_t scenario, const UnitDisplacements& model) const {
    auto motions = NodeMotion::of_all(model[scenario]);
    double sum = 0.0;
    for (const Sample& sample : samples_of(scenario)) {
        for (NodeMotion& motion : motions) motion.advance_to(sample);
        const double error = sample_error(sample, motions);
        sum += sample.weight * error * error;
    }
    return sum;
}

double Objective::value(const UnitDisplacements& model) const {
    double sum = 0.0;
    for (std::size_t s = 0; s < model.size(); ++s) sum += scenario_error(s, model);
    return sum;
}

std::vector<double> Objective::scenario_errors(const UnitDisplacements& model) const {
    std::vector<double> errors;
    for (std::size_t s = 0; s < model.size(); ++s) errors.push_back(scenario_error(s, model));
    return errors;
}

double Objective::answer_error(const Sample& sample, const mechanics::NodeValues& answer) {
    double translations = 0.0;
    double rotations = 0.0;
    for (std::size_t node = 0; node < sample.targets.size(); ++node) {
        const auto row = answer.row(static_cast<Eigen::Index>(node));
        const Target& target = sample.targets[node];
        translations += (Vector3d(row.head<3>()) - target.translation).norm();
        const Eigen::Quaterniond rotation = detail::rotation_of(row.tail<3>());
        rotations += detail::rotation_vector_of(target.inverse_rotation * rotation).norm();
    }
    return sample.translation_factor * translations + sample.rotation_factor * rotations;
}

std::vector<double> Objective::scenario_errors(const std::vector<Response>& model) const {
    std::vector<double> errors;
    for (std::size_t s = 0; s < model.size(); ++s) {
        double& sum = errors.emplace_back(0.0);
        for (const Sample& sample : samples_of(s)) {
            const Response::Sample& answer = model[s].samples.at(sample.place);
            if (!answer.converged)
                throw base::NumericalError("the model does not converge at step " +
                                           std::to_string(answer.step) + " of scenario '" +
                                           model[s].scenario + "', where the pattern does");
            const double error = answer_error(sample, answer.displacements);
            sum += sample.weight * error * error;
        }
    }
    return errors;
}

/// One interface node in one sample: how its two smoothed norms depend on the six components of its unit
/// displacement.
struct Objective::NodeTerm {
    NodeTerm(const Sample& sample, std::size_t node, const NodeMotion& motion,
             const std::array<double, 2>& rounding) {
        const double m = sample.magnitude;
        const Vector3d difference = motion.missed_translation(sample, node);
        const Vector3d angle = detail::rotation_vector_of(motion.missed_rotation(sample, node));
        const SmoothNorm translation = smooth_norm(difference, rounding[0]);
        const SmoothNorm rotation = smooth_norm(angle, rounding[1]);
        // The rotation vector `angle` changes by J_r(angle)^-1 J_r(turn) m du. It is itself a fixed vector of
        // the first factor, so the slope is exact without it; the curvature takes it as the identity.
        const Matrix3d rate = m * motion.right_jacobian();
        exact = {difference.norm(), angle.norm()};
        smoothed = {translation.value, rotation.value};
        slope << sample.translation_factor * m * translation.slope,
            sample.rotation_factor * rate.transpose() * rotation.slope;
        translation_bend = sample.translation_factor * m * m * translation.bend;
        rotation_bend = sample.rotation_factor * rate.transpose() * rotation.bend * rate;
    }

    std::array<double, 2> exact;
    std::array<double, 2> smoothed;
    Eigen::Matrix<double, 6, 1> slope;  ///< of the node's part of e
    Matrix3d translation_bend;          ///< second derivatives of the same
    Matrix3d rotation_bend;
};

/// Sums up derivatives over the samples. Second derivatives of one node under one scenario are summed over
/// the magnitudes before they meet the model's derivatives, which all magnitudes share.
class Objective::Differentiation {
  public:
    Differentiation(const Objective& owner, const UnitDisplacementsAndDerivatives& model, double smoothing)
        : owner_(owner), model_(model), smoothing_(smoothing) {
        const Eigen::Index parameters = model.derivatives.front().cols();
        jacobian.resize(static_cast<Eigen::Index>(owner.samples_.size()), parameters);
        errors.resize(jacobian.rows());
        bends_.resize(model.displacements.size());
        for (std::size_t s = 0; s < bends_.size(); ++s) {
            bends_[s].resize(static_cast<std::size_t>(model.displacements[s].rows()));
        }
        slopes_.resize(6 * model.displacements.front().rows(), jacobian.rows());
        for (std::size_t s = 0; s < bends_.size(); ++s) add_scenario(s);
    }

    /// Sum over nodes of the parts of the curvature that come from the norms.
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
    double value = 0.0;        ///< with smoothed norms
    Eigen::VectorXd errors;    ///< sqrt(w) e, smoothed, one a sample
    Eigen::MatrixXd jacobian;  ///< of these

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
            add_sample(samples[k], motions, first + k);
            add_bends(samples[k], bends_[s], errors[first + k]);
        }
        jacobian.middleRows(first, count).noalias() =
            slopes_.middleCols(first, count).transpose() * model_.derivatives[s];
    }

    void add_sample(const Sample& sample, std::span<const NodeMotion> motions, Eigen::Index row) {
        const std::array<double, 2> rounding = rounding_of(sample);
        terms_.clear();
        const double root = std::sqrt(sample.weight);
        double exact = 0.0;
        double smoothed = 0.0;
        for (std::size_t node = 0; node < motions.size(); ++node) {
            const NodeTerm& term = terms_.emplace_back(sample, node, motions[node], rounding);
            exact += sample.translation_factor * term.exact[0] + sample.rotation_factor * term.exact[1];
            smoothed +=
                sample.translation_factor * term.smoothed[0] + sample.rotation_factor * term.smoothed[1];
            slopes_.block<6, 1>(static_cast<Eigen::Index>(6 * node), row) = root * term.slope;
        }
        objective += sample.weight * exact * exact;
        value += sample.weight * smoothed * smoothed;
        errors[row] = root * smoothed;
    }

    /// `error`: sqrt(w) e.
    void add_bends(const Sample& sample, std::vector<NodeBend>& bends, double error) {
        const double factor = 2.0 * std::sqrt(sample.weight) * error;
        for (std::size_t node = 0; node < terms_.size(); ++node) {
            bends[node].translation += factor * terms_[node].translation_bend;
            bends[node].rotation += factor * terms_[node].rotation_bend;
        }
    }

    [[nodiscard]] std::array<double, 2> rounding_of(const Sample& sample) const {
        const double share = smoothing_ / static_cast<double>(sample.targets.size());
        return {share * owner_.metric_.translation_weight / sample.translation_factor,
                share * owner_.metric_.rotation_weight / sample.rotation_factor};
    }

    const Objective& owner_;
    const UnitDisplacementsAndDerivatives& model_;
    double smoothing_;
    std::vector<std::vector<NodeBend>> bends_;
    std::vector<NodeTerm> terms_;
    Eigen::MatrixXd slopes_;  ///< of sqrt(w) e by the unit displacements, one column a sample
};

optimization::CurvatureEvaluation Objective::curvature(const UnitDisplacementsAndDerivatives& model,
                                                       double smoothing) const {
    const Differentiation d(*this, model, smoothing);
    return {d.objective, d.value, 2.0 * d.jacobian.transpose() * d.errors,
            2.0 * d.jacobian.transpose() * d.jacobian + d.norm_curvature()};
}

optimization::ResidualEvaluation Objective::residuals(const UnitDisplacementsAndDerivatives& model,
                                                      double smoothing) const {
    const Differentiation d(*this, model, smoothing);
    return {d.objective, d.errors, d.jacobian};
}

}  // namespace fretwork::reduction
