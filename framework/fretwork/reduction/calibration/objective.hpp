// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/optimization/problem.hpp>
#include <fretwork/reduction/response.hpp>
#include <fretwork/reduction/unit_displacements.hpp>

#include <Eigen/Geometry>

#include <numbers>
#include <span>
#include <vector>

namespace fretwork::reduction {

/// How translations and rotations enter the error of a sample: Eqs. (9) to (11), Table 2 and Section 7.1.
struct ErrorMetric {
    double translation_weight = 1.2;                            ///< w_trans
    double rotation_weight = 0.8;                               ///< w_rot
    double smallest_translation = 0.0003;                       ///< eps_trans, m
    double smallest_rotation = 0.1 * std::numbers::pi / 180.0;  ///< eps_rot, rad
};

/// E with its norms smoothed, and its derivatives by a model's unit displacements.
struct DisplacementGradient {
    double objective = 0.0;  ///< E itself
    double value = 0.0;      ///< of what is differentiated
    UnitDisplacements slopes;
};

/// The distance of a linear model from the responses of a pattern: E of Eqs. (8) to (11), exactly as written.
///
/// E = sum over scenarios and magnitudes of w e^2, where e is the weighted sum of two normalized sums over
/// the interface nodes: of |d_p - d_r|, and of the angle between the rotations R_p and R_r. Linear
/// displacements grow with the magnitude; linear rotations are taken as rotation vectors. Samples that did
/// not converge are left out; so are those past the first loss of stability where the setting's sample
/// policy says so.
///
/// E has a kink wherever a norm is zero. With smoothing mu > 0 each norm |a| becomes
/// sqrt(a^2 + (mu s)^2), where s is the sample's normalizer divided by the number of nodes.
class Objective {
  public:
    /// Throws InputError if the responses do not fit the setting.
    Objective(const std::vector<Response>& responses, const Setting& setting, const ErrorMetric& metric = {});

    [[nodiscard]] double value(const UnitDisplacements& model) const;
    /// The parts of E, one for each scenario of the setting.
    [[nodiscard]] std::vector<double> scenario_errors(const UnitDisplacements& model) const;
    /// The same parts for a model that is not linear, from its own responses to the same setting. Throws
    /// NumericalError that names the sample if the model did not converge where the pattern did.
    [[nodiscard]] std::vector<double> scenario_errors(const std::vector<Response>& model) const;

    /// By the displacements themselves: the start of an adjoint gradient, which needs no derivatives of
    /// these.
    [[nodiscard]] DisplacementGradient gradient(const UnitDisplacements& model, double smoothing) const;
    /// Gradient and generalized Gauss-Newton matrix with respect to the model's parameters: the curvature of
    /// the norms is kept, second derivatives of the displacements are not. Not less than 2 J^T J.
    [[nodiscard]] optimization::CurvatureEvaluation curvature(const UnitDisplacementsAndDerivatives& model,
                                                              double smoothing) const;
    /// One residual sqrt(w) e for each sample, in the order of the responses.
    [[nodiscard]] optimization::ResidualEvaluation residuals(const UnitDisplacementsAndDerivatives& model,
                                                             double smoothing) const;

    [[nodiscard]] std::size_t sample_count() const { return samples_.size(); }

  private:
    /// The displacement of one interface node in a sample.
    struct Target {
        Eigen::Vector3d translation;
        Eigen::Quaterniond inverse_rotation;
    };
    struct Sample {
        std::size_t place;  ///< among the samples of its response
        double magnitude;
        double step;         ///< from the sample before, or from 0
        bool is_other_step;  ///< than the one before took
        double weight;
        double translation_factor;  ///< w_trans over the normalizer of Eq. (10)
        double rotation_factor;     ///< w_rot over the normalizer of Eq. (11)
        std::vector<Target> targets;
    };
    class NodeMotion;
    struct NodeTerm;
    class SampleTerms;
    class Differentiation;

    static Sample make_sample(const Response::Sample& sample, double weight, const ErrorMetric& metric);
    static double answer_error(const Sample& sample, const mechanics::NodeValues& answer);
    [[nodiscard]] DisplacementGradient smoothed_gradient(const UnitDisplacements& model,
                                                         double smoothing) const;
    [[nodiscard]] DisplacementGradient exact_gradient(const UnitDisplacements& model) const;
    /// e, and into `slopes` its derivatives by each node's unit displacement.
    static double differentiated_error(const Sample& sample, std::span<const NodeMotion> motions,
                                       std::span<Eigen::Matrix<double, 6, 1>> slopes);
    static void set_steps(std::span<Sample> samples);
    static double sample_error(const Sample& sample, std::span<const NodeMotion> motions);
    [[nodiscard]] std::span<const Sample> samples_of(std::size_t scenario) const;
    [[nodiscard]] double scenario_error(std::size_t scenario, const UnitDisplacements& model) const;

    ErrorMetric metric_;
    std::vector<Sample> samples_;
    std::vector<std::size_t> first_samples_;  ///< of each scenario; at last: the number of samples
};

}  // namespace fretwork::reduction
