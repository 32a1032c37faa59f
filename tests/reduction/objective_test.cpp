// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixtures.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/reduction/calibration/objective.hpp>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace fretwork::reduction {
namespace THIS_TEST {

/// A pattern's responses, its model and its problem at some point.
struct Example {
    Setting setting = paper_setting();
    RingHexagon model{setting};
    std::vector<Response> responses = compute_responses(paper_layout(), paper_pattern("0-1+1-6"), setting);
    Objective objective{responses, setting};
    RingProblem problem{model, paper6_parameters(), objective, setting};

    Eigen::VectorXd random_point(base::RandomStream& random) const {
        return problem.point(random_parameters(setting, random, 0.4, 0.6).values());
    }
};

const Example& example() {
    static const Example instance;
    return instance;
}

/// The angle between two rotations from the trace of their matrices.
double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const auto matrix = [](const Eigen::Vector3d& v) {
        return Eigen::AngleAxisd(v.norm(), v.norm() > 0 ? v.normalized() : Eigen::Vector3d::UnitX()).matrix();
    };
    const Eigen::Matrix3d relative = matrix(a).transpose() * matrix(b);
    return Eigen::AngleAxisd(relative).angle();
}

/// Eqs. (8) to (11) written down as the paper has them, with its numbers.
double written_objective(const std::vector<Response>& responses, const UnitDisplacements& model) {
    const double w[] = {0.5, 0.5, 1.0, 1.0, 1.0};
    double E = 0.0;
    for (std::size_t s = 0; s < 5; ++s) {
        for (const auto& sample : responses[s].samples) {
            if (!sample.converged) continue;
            double trans = 0.0, trans_norm = 0.0, rot = 0.0, rot_norm = 0.0;
            for (int v = 0; v < 6; ++v) {
                const Eigen::Vector3d dp = sample.displacements.row(v).head<3>();
                const Eigen::Vector3d rp = sample.displacements.row(v).tail<3>();
                trans += (dp - sample.magnitude * model[s].row(v).head<3>().transpose()).norm();
                trans_norm += dp.norm();
                rot += angle_between(rp, sample.magnitude * model[s].row(v).tail<3>().transpose());
                rot_norm += angle_between(rp, Eigen::Vector3d::Zero());
            }
            const double e = 1.2 * trans / std::max(trans_norm, 0.0003) +
                             0.8 * rot / std::max(rot_norm, 0.1 * std::numbers::pi / 180.0);
            E += w[s] * e * e;
        }
    }
    return E;
}

TEST(Objective, IsThatOfThePaperExactlyAsWritten) {
    base::RandomStream random(1, 0);
    for (int trial = 0; trial < 5; ++trial) {
        const auto model =
            example().model.displacements(random_parameters(example().setting, random, 0.4, 0.6));
        const double expected = written_objective(example().responses, model);
        EXPECT_NEAR(example().objective.value(model), expected, 1e-7 * expected);
    }
}

TEST(Objective, DividesByTheThresholdsWhereDisplacementsAreBelowThem) {
    // Under a thousandth of the loads the displacements are below both thresholds.
    Setting setting = example().setting;
    for (Scenario& scenario : setting.scenarios) scenario.max_magnitude *= 1e-3;
    const auto responses = compute_responses(paper_layout(), paper_pattern("0-1+1-6"), setting);
    base::RandomStream random(2, 0);
    const auto model = example().model.displacements(random_parameters(setting, random, 0.4, 0.6));
    const double expected = written_objective(responses, model);
    EXPECT_NEAR(Objective(responses, setting).value(model), expected, 1e-6 * expected);
}

TEST(Objective, IsZeroWhereModelAndPatternAgree) {
    const Setting& setting = example().setting;
    base::RandomStream random(3, 0);
    const auto model = example().model.displacements(random_parameters(setting, random, 0.4, 0.6));
    EXPECT_NEAR(Objective(linear_responses(model, setting), setting).value(model), 0.0, 1e-10);
}

TEST(Objective, IsTheSumOfItsScenarios) {
    base::RandomStream random(4, 0);
    const auto model = example().model.displacements(random_parameters(example().setting, random, 0.4, 0.6));
    double sum = 0.0;
    for (const double part : example().objective.scenario_errors(model)) sum += part;
    EXPECT_NEAR(sum, example().objective.value(model), 1e-12 * sum);
}

TEST(Objective, GradientAgreesWithFiniteDifferences) {
    base::RandomStream random(5, 0);
    for (const double smoothing : {0.1, 1e-3, 0.0}) {
        for (int trial = 0; trial < 4; ++trial) {
            const Eigen::VectorXd x = example().random_point(random);
            const auto exact = example().problem.gradient(x, smoothing);
            for (int i = 0; i < 6; ++i) {
                constexpr double kStep = 1e-6;
                const Eigen::VectorXd e = kStep * Eigen::VectorXd::Unit(6, i);
                const double slope = (example().problem.gradient(x + e, smoothing).value -
                                      example().problem.gradient(x - e, smoothing).value) /
                                     (2.0 * kStep);
                EXPECT_NEAR(exact.gradient[i], slope, 1e-5 * (std::abs(slope) + exact.value))
                    << "variable " << i;
            }
        }
    }
}

TEST(Objective, GradientAloneIsThatOfTheCurvature) {
    base::RandomStream random(9, 0);
    for (const double smoothing : {0.1, 1e-3, 0.0}) {
        const Eigen::VectorXd x = example().random_point(random);
        const auto gradient = example().problem.gradient(x, smoothing);
        const auto model = example().problem.curvature(x, smoothing);
        // Both evaluate the same terms and add them up in another order.
        EXPECT_NEAR(gradient.objective, model.objective, 1e-12 * model.objective);
        EXPECT_NEAR(gradient.value, model.value, 1e-12 * model.value);
        EXPECT_LT((gradient.gradient - model.gradient).norm(), 1e-9 * model.gradient.norm());
    }
}

TEST(Objective, SquaredResidualsSumToItsValue) {
    base::RandomStream random(6, 0);
    const Eigen::VectorXd x = example().random_point(random);
    const auto r = example().problem.residuals(x, 0.0);
    ASSERT_EQ(r.residuals.size(), 50);
    EXPECT_NEAR(r.residuals.squaredNorm(), example().problem.value(x), 1e-10 * r.objective);
    const auto g = example().problem.gradient(x, 0.0);
    EXPECT_LT((2.0 * r.jacobian.transpose() * r.residuals - g.gradient).norm(), 1e-9 * g.gradient.norm());
}

TEST(Objective, CurvatureIsAtLeastThatOfTheResiduals) {
    base::RandomStream random(7, 0);
    for (const double smoothing : {0.1, 1e-4}) {
        const Eigen::VectorXd x = example().random_point(random);
        const auto model = example().problem.curvature(x, smoothing);
        const auto r = example().problem.residuals(x, smoothing);
        const Eigen::MatrixXd excess = model.curvature - 2.0 * r.jacobian.transpose() * r.jacobian;
        const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(excess).eigenvalues();
        EXPECT_GT(values.minCoeff(), -1e-9 * values.maxCoeff());
    }
}

/// Where the model is linear in a variable and rotations are small, the generalized Gauss-Newton matrix is
/// the Hessian: a translation error that grows with one parameter.
TEST(Objective, CurvatureIsTheHessianForALinearModel) {
    const Setting& setting = example().setting;
    base::RandomStream random(8, 0);
    UnitDisplacements base = example().model.displacements(random_parameters(setting, random, 0.45, 0.55));
    const auto other = example().model.displacements(random_parameters(setting, random, 0.45, 0.55));
    for (auto& scenario : base) scenario.rightCols<3>().setZero();
    const auto at = [&](double t) {
        UnitDisplacementsAndDerivatives model;
        for (std::size_t s = 0; s < 5; ++s) {
            mechanics::NodeValues slope = other[s];
            slope.rightCols<3>().setZero();
            model.displacements.push_back(base[s] + t * slope);
            model.derivatives.emplace_back(slope.reshaped<Eigen::RowMajor>());
        }
        return model;
    };
    constexpr double kSmoothing = 0.1;
    constexpr double kStep = 1e-4;
    const auto center = example().objective.curvature(at(0.3), kSmoothing);
    const double hessian = (example().objective.curvature(at(0.3 + kStep), kSmoothing).gradient[0] -
                            example().objective.curvature(at(0.3 - kStep), kSmoothing).gradient[0]) /
                           (2.0 * kStep);
    EXPECT_NEAR(center.curvature(0, 0), hessian, 1e-5 * hessian);
}

TEST(Objective, LeavesOutWhatDidNotConverge) {
    auto responses = example().responses;
    for (auto& response : responses) {
        for (auto& sample : response.samples) sample.stable = true;
    }
    responses[3].samples[9].converged = false;
    responses[3].samples[9].displacements.setConstant(1e3);
    const Objective paper(responses, example().setting);
    EXPECT_EQ(paper.sample_count(), 49U);
}

TEST(Objective, CountsSamplesAfterOneThatDidNotConverge) {
    auto responses = example().responses;
    responses[2].samples[4].converged = false;
    const Objective with_gap(responses, example().setting);
    base::RandomStream random(6, 0);
    const UnitDisplacements model = example().problem.displacements(example().random_point(random));
    const double expected = written_objective(responses, model);
    EXPECT_NEAR(with_gap.value(model), expected, 1e-7 * expected);
    EXPECT_LT(expected, written_objective(example().responses, model));
}

TEST(Objective, StablePolicyLeavesOutEverySampleFromTheFirstUnstableOneOn) {
    auto responses = example().responses;
    for (auto& response : responses) {
        for (auto& sample : response.samples) sample.stable = true;
    }
    responses[0].samples[6].stable = false;  // and stable again at 7, 8 and 9
    responses[3].samples[9].converged = false;
    responses[3].samples[9].stable = false;
    Setting stable = example().setting;
    stable.sample_policy = SamplePolicy::Stable;
    EXPECT_EQ(Objective(responses, stable).sample_count(), 45U);
    EXPECT_EQ(Objective(responses, example().setting).sample_count(), 49U);
    // Components that are left out do not count.
    const Objective before(responses, stable);
    for (std::size_t k = 6; k < 10; ++k) responses[0].samples[k].displacements.setConstant(1.0);
    base::RandomStream random(5, 0);
    const UnitDisplacements model = example().problem.displacements(example().random_point(random));
    EXPECT_EQ(before.value(model), Objective(responses, stable).value(model));
    EXPECT_NE(before.value(model), Objective(responses, example().setting).value(model));
}

TEST(Objective, RefusesResponsesThatDoNotFit) {
    auto responses = example().responses;
    responses.pop_back();
    EXPECT_THROW(Objective(responses, example().setting), base::InputError);
    responses = example().responses;
    responses[1].samples[0].displacements.conservativeResize(5, 6);
    EXPECT_THROW(Objective(responses, example().setting), base::InputError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction
