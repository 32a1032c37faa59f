// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/rotation.hpp>
#include <fretwork/reduction/calibration/objective.hpp>
#include <fretwork/reduction/detail/node_motion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace fretwork::reduction {
namespace {

using Eigen::Vector3d;

/// The samples of a response that the sample policy keeps.
std::vector<const Response::Sample*> used_samples(const Response& response, const Setting& setting) {
    std::vector<const Response::Sample*> used;
    for (const Response::Sample& sample : response.samples) {
        // A specimen leaves a path that has lost its stability, so later samples are left out even if the
        // path is stable again.
        if (setting.sample_policy == SamplePolicy::Stable && sample.converged && !sample.stable) break;
        if (sample.converged) used.push_back(&sample);
    }
    return used;
}

/// Check that a response has one sample for each magnitude of its scenario.
void check_samples(const Response& response, const Scenario& scenario, int magnitudes) {
    constexpr double kRoundOff = 1e-9;
    if (std::ssize(response.samples) != magnitudes)
        throw base::InputError("the response to '" + scenario.name + "' has " +
                               base::counted(response.samples.size(), "sample") + ", and the setting has " +
                               base::counted(static_cast<std::size_t>(magnitudes), "magnitude"));
    for (int k = 1; k <= magnitudes; ++k) {
        const Response::Sample& sample = response.samples[static_cast<std::size_t>(k) - 1];
        const double magnitude = scenario.max_magnitude * k / magnitudes;
        const double difference = std::abs(sample.magnitude - magnitude);
        if (sample.step == k && difference <= kRoundOff * std::abs(magnitude)) continue;
        throw base::InputError("sample " + std::to_string(k) + " of the response to '" + scenario.name +
                               "' has step " + std::to_string(sample.step) + " and magnitude " +
                               base::format_number(sample.magnitude) + " N, where the setting has step " +
                               std::to_string(k) + " and " + base::format_number(magnitude) + " N");
    }
}

}  // namespace

void check_fit(const std::vector<Response>& responses, const Setting& setting,
               std::optional<Eigen::Index> nodes) {
    const bool as_many = responses.size() == setting.scenarios.size();
    for (std::size_t i = 0; i < setting.scenarios.size(); ++i) {
        if (!as_many || responses[i].scenario != setting.scenarios[i].name)
            throw base::InputError("the responses lack scenario '" + setting.scenarios[i].name +
                                   "' in its place");
        check_samples(responses[i], setting.scenarios[i], setting.magnitudes);
    }
    for (const Response& response : responses) {
        for (const Response::Sample& sample : response.samples) {
            const Eigen::Index own = sample.displacements.rows();
            if (!nodes && own > 0 && own % setting.sides == 0) nodes = own;
            if (own == nodes) continue;
            throw base::InputError("a response to '" + response.scenario + "' has " + std::to_string(own) +
                                   " interface nodes, not " +
                                   (nodes
                                        ? std::to_string(*nodes)
                                        : "as many on each of " + std::to_string(setting.sides) + " sides"));
        }
    }
}

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

/// Set the steps between magnitudes. Steps that differ only by the rounding of the magnitudes count as equal.
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
        const Eigen::Quaterniond rotation = geometry::exponential(row.tail<3>());
        translations += translation.norm();
        rotations += geometry::logarithm(rotation).norm();
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
        const Eigen::Quaterniond rotation = geometry::exponential(row.tail<3>());
        rotations += geometry::logarithm(target.inverse_rotation * rotation).norm();
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

}  // namespace fretwork::reduction
