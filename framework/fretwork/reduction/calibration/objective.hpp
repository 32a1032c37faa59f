// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/problem.hpp>
#include <fretwork/reduction/response.hpp>
#include <fretwork/reduction/unit_displacements.hpp>

#include <Eigen/Geometry>

#include <numbers>
#include <optional>
#include <span>
#include <vector>

namespace fretwork::reduction {

/// The weights of translations and rotations in the error of a sample: Eqs. (9) to (11), Table 2 and Section
/// 7.1.
struct ErrorMetric {
    double translation_weight = 1.2;                            ///< w_trans
    double rotation_weight = 0.8;                               ///< w_rot
    double smallest_translation = 0.0003;                       ///< eps_trans, m
    double smallest_rotation = 0.1 * std::numbers::pi / 180.0;  ///< eps_rot, rad
};

/// Check that responses fit a setting: one for each scenario, in order, with one sample for each magnitude,
/// all with the same interface nodes. Throws InputError.
/// @param nodes  number of interface nodes; none: that of the first sample, equally many on each side
void check_fit(const std::vector<Response>& responses, const Setting& setting,
               std::optional<Eigen::Index> nodes = {});

/// The derivatives of E, with its norms smoothed, with respect to a model's unit displacements.
struct DisplacementGradient {
    double objective = 0.0;    ///< E without smoothing
    double value = 0.0;        ///< E with its norms smoothed
    UnitDisplacements slopes;  ///< derivatives of `value` with respect to each unit displacement
};

/// The distance of a linear model from the responses of a pattern: E of Eqs. (8) to (11).
///
/// E is the sum of w e^2 over scenarios and magnitudes. The error e is a weighted sum of two normalized sums
/// over the interface nodes: the sum of |d_p - d_r|, and the sum of the angles between the rotations R_p and
/// R_r (p: pattern; r: reduced model). Linear displacements are proportional to the magnitude; linear
/// rotations are taken as rotation vectors. Samples that did not converge are left out. The setting's sample
/// policy decides whether samples past the first loss of stability are left out, too.
///
/// E has a kink wherever a norm is zero. With smoothing mu > 0 each norm |a| becomes
/// sqrt(a^2 + (mu s)^2), where s is the sample's normalizer divided by the number of nodes.
class Objective {
  public:
    /// Make the objective for a pattern's responses. Throws InputError if the responses do not fit the
    /// setting.
    Objective(const std::vector<Response>& responses, const Setting& setting, const ErrorMetric& metric = {});

    /// E of a linear model.
    [[nodiscard]] double value(const UnitDisplacements& model) const;
    /// The contributions to E, one for each scenario of the setting.
    [[nodiscard]] std::vector<double> scenario_errors(const UnitDisplacements& model) const;
    /// The contributions to E for a nonlinear model, given its responses in the same setting. Throws
    /// NumericalError that names a sample if the pattern converged there but the model did not.
    [[nodiscard]] std::vector<double> scenario_errors(const std::vector<Response>& model) const;

    /// The gradient of E with respect to the displacements. It is the right side of an adjoint method, which
    /// needs no derivatives of the displacements.
    [[nodiscard]] DisplacementGradient gradient(const UnitDisplacements& model, double smoothing) const;
    /// The gradient and the generalized Gauss-Newton matrix of E with respect to the model's parameters. The
    /// matrix keeps the curvature of the norms and drops second derivatives of the displacements. It is at
    /// least 2 J^T J, where J is the Jacobian of residuals().
    [[nodiscard]] optimization::CurvatureEvaluation curvature(const UnitDisplacementsAndDerivatives& model,
                                                              double smoothing) const;
    /// One residual sqrt(w) e for each sample, in the order of the responses, with derivatives.
    [[nodiscard]] optimization::ResidualEvaluation residuals(const UnitDisplacementsAndDerivatives& model,
                                                             double smoothing) const;

    /// The number of samples that contribute to E.
    [[nodiscard]] std::size_t sample_count() const { return samples_.size(); }

  private:
    /// The displacement of one interface node in a sample.
    struct Target {
        Eigen::Vector3d translation;
        Eigen::Quaterniond inverse_rotation;
    };
    struct Sample {
        std::size_t place;  ///< index among the samples of its response
        double magnitude;
        double step;         ///< difference from the previous sample's magnitude, or from 0
        bool is_other_step;  ///< true if the step differs from the previous sample's step
        double weight;
        double translation_factor;  ///< w_trans over the normalizer of Eq. (10)
        double rotation_factor;     ///< w_rot over the normalizer of Eq. (11)
        std::vector<Target> targets;
    };
    class NodeMotion;
    struct NodeTerm;
    class NodeBend;
    class SampleTerms;
    class Differentiation;

    static Sample make_sample(const Response::Sample& sample, double weight, const ErrorMetric& metric);
    static double answer_error(const Sample& sample, const mechanics::NodeValues& answer);
    [[nodiscard]] DisplacementGradient smoothed_gradient(const UnitDisplacements& model,
                                                         double smoothing) const;
    [[nodiscard]] DisplacementGradient exact_gradient(const UnitDisplacements& model) const;
    /// The error e of a sample. Writes the derivatives of e with respect to each node's unit displacement
    /// into `slopes`.
    static double differentiated_error(const Sample& sample, std::span<const NodeMotion> motions,
                                       std::span<Eigen::Matrix<double, 6, 1>> slopes);
    static void set_steps(std::span<Sample> samples);
    static double sample_error(const Sample& sample, std::span<const NodeMotion> motions);
    [[nodiscard]] std::span<const Sample> samples_of(std::size_t scenario) const;
    [[nodiscard]] double scenario_error(std::size_t scenario, const UnitDisplacements& model) const;

    ErrorMetric metric_;
    std::vector<Sample> samples_;
    std::vector<std::size_t> first_samples_;  ///< first sample of each scenario, followed by the number of
                                              ///< samples
};

}  // namespace fretwork::reduction
