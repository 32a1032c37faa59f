// SPDX-License-Identifier: GPL-3.0-or-later
#include "analytic_problems.hpp"
#include "support.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/random.hpp>
#include <fretwork/optimization/methods/detail/box_quadratic.hpp>
#include <fretwork/optimization/methods/multistart.hpp>
#include <fretwork/optimization/methods/pagmo_methods.hpp>
#include <fretwork/optimization/methods/simulated_annealing.hpp>
#include <fretwork/optimization/minimize.hpp>
#include <fretwork/optimization/problems/distance_sum_problem.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace fretwork::optimization {
namespace THIS_TEST {

TEST(BoxQuadratic, SatisfiesTheOptimalityConditionsForRandomProblems) {
    base::RandomStream random(1, 0);
    for (int trial = 0; trial < 300; ++trial) {
        const int n = 1 + trial % 7;
        Eigen::MatrixXd M(n, n);
        Eigen::VectorXd g(n);
        Bounds bounds{Eigen::VectorXd(n), Eigen::VectorXd(n)};
        for (double& entry : M.reshaped()) entry = random.laplace(1.0);
        for (double& entry : g) entry = random.laplace(3.0);
        for (double& entry : bounds.lower) entry = -random.uniform() * (trial % 3);
        for (double& entry : bounds.upper) entry = random.uniform();
        const Eigen::MatrixXd H = M.transpose() * M + 1e-3 * Eigen::MatrixXd::Identity(n, n);
        const Eigen::VectorXd p = detail::minimize_box_quadratic(H, g, bounds);
        ASSERT_TRUE(bounds.contain(p));
        // A convex problem: its conditions are sufficient.
        const Eigen::VectorXd slope = g + H * p;
        const double tolerance = 1e-9 * (1.0 + g.lpNorm<Eigen::Infinity>());
        for (int i = 0; i < n; ++i) {
            EXPECT_TRUE(p[i] == bounds.lower[i] || slope[i] < tolerance) << "trial " << trial;
            EXPECT_TRUE(p[i] == bounds.upper[i] || slope[i] > -tolerance) << "trial " << trial;
        }
    }
}

/// Three points of a wide triangle: the minimum of the sum of distances is its Fermat point, where the
/// directions to the corners make 120 degrees.
TEST(SmoothedMethods, FindTheFermatPoint) {
    const DistanceSumProblem problem(cube(2, -3.0, 3.0),
                                     (Eigen::MatrixXd(2, 3) << 0.0, 2.0, 0.5, 0.0, 0.0, 1.5).finished());
    for (const char* name : {"ceres-multistart", "gauss-newton-multistart"}) {
        const auto report = minimize(problem, find_optimizer(name), {.starts = 1}, {.cost = 2000});
        const Eigen::VectorXd slope = problem.gradient(report.point, 0.0).gradient;
        EXPECT_LT(slope.norm() / report.value, 1e-3) << name;
        EXPECT_EQ(report.ending, Ending::Converged) << name;
    }
}

/// With one angle beyond 120 degrees the minimum is that corner: a kink of the objective.
/// As the objective of a calibration: 1e12 where the descents begin, 1 at the minimum.
TEST(Slsqp, FindsAMinimumTwelvePowersOfTenBelowItsStarts) {
    const LeastSquaresProblem problem(
        "steep", cube(2, -14.0, 14.0),
        [](const Eigen::VectorXd& x) {
            return Eigen::VectorXd(Eigen::Vector3d(std::exp(x[0]), std::exp(-x[0]), std::sinh(x[1] - 1.0)));
        },
        [](const Eigen::VectorXd& x) {
            Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(3, 2);
            jacobian(0, 0) = std::exp(x[0]);
            jacobian(1, 0) = -std::exp(-x[0]);
            jacobian(2, 1) = std::cosh(x[1] - 1.0);
            return jacobian;
        });
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const auto report = minimize(problem, find_optimizer("slsqp"), {.starts = 4, .seed = seed});
        EXPECT_NEAR(report.value, 2.0, 1e-6);
        EXPECT_EQ(report.dead_starts, 0);
        EXPECT_EQ(report.trace.back().value, report.value) << "the trace is of the objective itself";
    }
}

/// Only near the middle of the box is there anything to descend on.
TEST(DeadStarts, AreCountedAndAreNoDescent) {
    const auto with_hole = [](double radius) {
        return LeastSquaresProblem(
            "hole", cube(2, -1.0, 1.0),
            [=](const Eigen::VectorXd& x) { return x.norm() < radius ? x : (NAN * x).eval(); },
            [](const Eigen::VectorXd&) { return Eigen::MatrixXd::Identity(2, 2).eval(); });
    };
    for (const char* name : {"slsqp", "ceres-residuals"}) {
        const auto some = minimize(with_hole(0.9), find_optimizer(name), {.starts = 16});
        EXPECT_GT(some.dead_starts, 0) << name;
        EXPECT_LT(some.dead_starts, 16) << name;
        EXPECT_LT(some.value, 1e-6) << name;
        EXPECT_NE(some.ending, Ending::Invalid) << name;
        const auto none = minimize(with_hole(0.0), find_optimizer(name), {.starts = 16});
        EXPECT_EQ(none.dead_starts, 16) << name;
        EXPECT_EQ(none.ending, Ending::Invalid) << name;
    }
}

/// The derivatives of a point's distances from another along the axes, for x up to 0.5 only.
Eigen::MatrixXd slopes_at_left(const Eigen::VectorXd& x) {
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Identity(2, 2);
    if (x[0] > 0.5) slopes.setConstant(NAN);
    return slopes;
}

TEST(DeadStarts, AreThoseWithoutASlopeToo) {
    const LeastSquaresProblem problem(
        "no slopes at right", cube(2, -2.0, 2.0), [](const Eigen::VectorXd& x) { return x; }, slopes_at_left);
    for (const char* name : {"ceres-residuals", "ceres-dogleg", "ceres-sine", "ceres-smoothed"}) {
        const auto report = minimize(problem, find_optimizer(name), {.starts = 16});
        EXPECT_GT(report.dead_starts, 0) << name;
        EXPECT_LT(report.dead_starts, 16) << name;
        EXPECT_LT(report.value, 1e-6) << name;
        EXPECT_NE(report.ending, Ending::Invalid) << name;
    }
}

TEST(SmoothedMethods, FindAMinimumInAKink) {
    const DistanceSumProblem problem(cube(2, -3.0, 3.0),
                                     (Eigen::MatrixXd(2, 3) << 0.0, 2.0, -2.0, 0.0, 0.3, 0.3).finished());
    const double best = problem.value(Eigen::Vector2d(0.0, 0.0));
    for (const char* name : {"ceres-multistart", "gauss-newton-multistart"}) {
        const auto report = minimize(problem, find_optimizer(name), {.starts = 1}, {.cost = 2000});
        EXPECT_LT(report.value, best * (1.0 + 1e-3)) << name;
        EXPECT_GE(report.value, best) << name;
    }
}

/// Cold annealing stays in the valley of its start, and so does a descent.
TEST(SeveralStarts, EndWhereTheBestStartEnded) {
    const LeastSquaresProblem problem = two_valleys();
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const OptimizerOptions common{.starts = 4, .seed = seed};
        const ContinuationOptions one_stage{.smoothing = {1e-4}, .samples_per_start = 1};
        const MultistartOptions descents{.common = common, .continuation = one_stage};
        std::vector<std::unique_ptr<Optimizer>> methods;
        methods.push_back(make_ceres_multistart(descents));
        methods.push_back(make_gauss_newton_multistart(descents));
        methods.push_back(make_simulated_annealing(
            {.common = common, .initial_temperature = 1e-6, .initial_move = 1e-3, .largest_move = 1e-2}));
        for (const auto& method : methods) {
            const auto report = minimize(problem, *method, {.cost = 100000});
            EXPECT_NEAR(problem.value(report.final_point), report.value, 0.05) << "seed " << seed;
        }
    }
}

/// (x^2 - 1)^2 + 0.09 (x - 1)^2 has a minimum of 0 in 1 and one of some 0.3 near -1: the descents there are
/// given up after the first stage, and nothing is lost.
TEST(Multistart, GivesUpDescentsThatStayFarAboveTheLowest) {
    const LeastSquaresProblem problem = two_valleys();
    for (const auto make : {make_ceres_multistart, make_gauss_newton_multistart}) {
        const auto run = [&](double pruning_ratio) {
            Evaluator evaluator(problem, {.cost = 10000});
            const auto method = make({.common = {.starts = 8},
                                      .continuation = {.samples_per_start = 1},
                                      .pruning_ratio = pruning_ratio});
            EXPECT_EQ(method->run(evaluator).ending, Ending::Converged);
            EXPECT_LT(evaluator.best_value(), 1e-9);
            return evaluator.cost();
        };
        EXPECT_LT(run(2.0), run(std::numeric_limits<double>::infinity()));
        EXPECT_THROW(make({.pruning_ratio = 0.9}), base::InputError);
    }
}

TEST(Multistart, TakesMoreSamplesThanAnIntCounts) {
    const LeastSquaresProblem problem = sphere(2);
    for (const auto make : {make_ceres_multistart, make_gauss_newton_multistart}) {
        Evaluator evaluator(problem, {.cost = 50});
        const auto method =
            make({.common = {.starts = 100'000}, .continuation = {.samples_per_start = 30'000}});
        EXPECT_EQ(method->run(evaluator).ending, Ending::BudgetSpent);
        EXPECT_EQ(evaluator.evaluations(), 50);
        EXPECT_EQ(evaluator.derivative_evaluations(), 0) << "no descent before all points are sampled";
    }
}

TEST(Multistart, GivesUpADescentWithoutASlope) {
    const LeastSquaresProblem problem(
        "no slopes", cube(2, -1.0, 1.0), [](const Eigen::VectorXd& x) { return x; },
        [](const Eigen::VectorXd&) { return Eigen::MatrixXd::Constant(2, 2, NAN).eval(); });
    for (const auto make : {make_ceres_multistart, make_gauss_newton_multistart}) {
        Evaluator evaluator(problem, {.cost = 10000});
        const auto method =
            make({.common = {.starts = 1}, .continuation = {.smoothing = {1e-1}, .samples_per_start = 1}});
        EXPECT_EQ(method->run(evaluator).ending, Ending::Stalled);
        EXPECT_EQ(evaluator.cost(), 1);
    }
}

/// The minimum in (1, 1) lies where there are no derivatives.
TEST(Multistart, EndsOnlyWhereThereAreDerivatives) {
    const LeastSquaresProblem problem(
        "minimum without slopes", cube(2, -2.0, 2.0),
        [](const Eigen::VectorXd& x) { return Eigen::VectorXd(x.array() - 1.0); }, slopes_at_left);
    for (const auto make : {make_ceres_multistart, make_gauss_newton_multistart}) {
        Evaluator evaluator(problem, {.cost = 1000000});
        const auto method = make({.common = {.starts = 8}, .continuation = {.samples_per_start = 1}});
        EXPECT_LE(method->run(evaluator).final_point[0], 0.5);
    }
}

/// From the minimum itself nothing can be gained, and a stage needs no evaluation beyond that of its start.
TEST(Multistart, SpendsOneEvaluationAStageWhereNothingIsToBeGained) {
    const LeastSquaresProblem problem(
        "line", cube(1, -1.0, 1.0), [](const Eigen::VectorXd& x) { return Eigen::VectorXd(x.array() + 2.0); },
        [](const Eigen::VectorXd&) { return Eigen::MatrixXd::Ones(1, 1).eval(); });
    for (const auto make : {make_ceres_multistart, make_gauss_newton_multistart}) {
        Evaluator evaluator(problem, {.cost = 10000});
        const MultistartOptions once{
            .common = {.starts = 1},
            .continuation = {.smoothing = {1e-1, 1e-2, 1e-3}, .samples_per_start = 1}};
        EXPECT_EQ(make(once)->run(evaluator).ending, Ending::Converged);
        EXPECT_EQ(evaluator.best_point()[0], -1.0);
        // One step to the bound in the first stage.
        EXPECT_EQ(evaluator.cost(), 4);
    }
}

/// Remembers every point at which it was evaluated.
class RecordedQuadratic final : public Problem {
  public:
    [[nodiscard]] std::string name() const override { return "recorded"; }
    [[nodiscard]] const Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] double value(const Eigen::VectorXd& x) const override {
        points.push_back(x);
        return 10.0 * x.squaredNorm();
    }
    mutable std::vector<Eigen::VectorXd> points;

  private:
    Bounds bounds_ = cube(3, 0.0, 1.0);
};

TEST(SimulatedAnnealing, MovesOneVariableAtATimeInTurn) {
    const RecordedQuadratic problem;
    const auto annealing =
        make_simulated_annealing({.common = {.starts = 1, .seed = 2}, .initial_temperature = 1e300});
    (void)minimize(problem, *annealing, {.cost = 200});
    // At this temperature every move is accepted, so consecutive points differ in one variable.
    for (std::size_t k = 1; k < problem.points.size(); ++k) {
        for (Eigen::Index i = 0; i < 3; ++i) {
            const bool moves = problem.points[k][i] != problem.points[k - 1][i];
            EXPECT_EQ(moves, i == static_cast<Eigen::Index>((k - 1) % 3));
        }
    }
}

TEST(SimulatedAnnealing, IsFrozenAfterThreeTimesAHundredSweepsWithoutChange) {
    const ::fretwork::optimization::LeastSquaresProblem flat(
        "flat", cube(2, 0.0, 1.0), [](const auto&) { return Eigen::VectorXd::Ones(1).eval(); },
        [](const auto&) { return Eigen::MatrixXd::Zero(1, 2).eval(); });
    const auto report =
        minimize(flat, find_optimizer("simulated-annealing"), {.starts = 1}, {.cost = 100000});
    EXPECT_EQ(report.ending, Ending::Converged);
    // The 1,000 initial moves do not count as frozen.
    EXPECT_EQ(report.evaluations, 1 + 1000 + 3 * 100 * 2);
}

/// A box in which half of all moves lead outside, and a least value on a corner.
std::vector<Eigen::VectorXd> points_of(const SimulatedAnnealingOptions& options) {
    const RecordedQuadratic problem;
    (void)minimize(problem, *make_simulated_annealing(options), {.cost = 400});
    return problem.points;
}

TEST(SimulatedAnnealing, KeepsBoundsByReflectionClampingOrRejection) {
    SimulatedAnnealingOptions options{
        .common = {.starts = 1, .seed = 3}, .largest_moves = 300, .initial_moves = 50};
    const auto on_bound = [](const auto& points) {
        return std::ranges::count_if(points, [](const Eigen::VectorXd& x) {
            return (x.array() == 0.0).any() || (x.array() == 1.0).any();
        });
    };
    const auto reflected = points_of(options);
    options.bounds = AnnealingBounds::Clamp;
    const auto clamped = points_of(options);
    options.bounds = AnnealingBounds::Reject;
    const auto rejected = points_of(options);
    EXPECT_EQ(on_bound(reflected), 0);
    EXPECT_GT(on_bound(clamped), 50);
    EXPECT_EQ(on_bound(rejected), 0);
    EXPECT_EQ(reflected.size(), 351U);
    EXPECT_LT(rejected.size(), 300U) << "a rejected move is not evaluated";
}

/// Between points without a value every move is accepted, but none beyond a bound.
TEST(SimulatedAnnealing, RejectsMovesBeyondABoundAlsoWhereThereIsNoValue) {
    const LeastSquaresProblem hole(
        "hole", cube(2, 0.0, 1.0), [](const Eigen::VectorXd& x) { return (NAN * x).eval(); },
        [](const Eigen::VectorXd&) { return Eigen::MatrixXd::Identity(2, 2).eval(); });
    const auto annealing = make_simulated_annealing({.common = {.starts = 1, .seed = 5},
                                                     .largest_moves = 50,
                                                     .initial_moves = 50,
                                                     .initial_move = 5.0,
                                                     .bounds = AnnealingBounds::Reject});
    Evaluator evaluator(hole, {.cost = 1000});
    const Eigen::VectorXd end = annealing->run(evaluator).final_point;
    EXPECT_TRUE((end.array() > 0.0).all() && (end.array() < 1.0).all()) << end.transpose();
}

/// x is the logarithm of a quantity between 1 and e^10.
class LogarithmicProblem final : public Problem {
  public:
    [[nodiscard]] std::string name() const override { return "logarithmic"; }
    [[nodiscard]] const Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] bool is_logarithm(int) const override { return true; }
    [[nodiscard]] double value(const Eigen::VectorXd& x) const override {
        points.push_back(x);
        return 0.0;
    }
    mutable std::vector<Eigen::VectorXd> points;

  private:
    Bounds bounds_ = cube(1, 0.0, 10.0);
};

TEST(SimulatedAnnealing, MovesUniformlyInQuantitiesOnRequest) {
    const LogarithmicProblem problem;
    const auto annealing = make_simulated_annealing({.common = {.starts = 1, .seed = 4},
                                                     .largest_moves = 2000,
                                                     .initial_moves = 2000,
                                                     .variables = AnnealingVariables::Quantities});
    (void)minimize(problem, *annealing, {.cost = 2001});
    // Every move is accepted and reflected: the quantity is uniform, so its median lies in the middle.
    const auto above = std::ranges::count_if(
        problem.points, [](const Eigen::VectorXd& x) { return std::exp(x[0]) > 0.5 * std::exp(10.0); });
    EXPECT_NEAR(static_cast<double>(above) / static_cast<double>(problem.points.size()), 0.5, 0.1);
}

TEST(Evolution, IsStalledIfItSpendsItsGenerations) {
    const auto problem = rosenbrock(cube(2, -2.0, 2.0));
    for (const auto make : {make_cma_es, make_differential_evolution}) {
        const auto ending = [&](int largest_generations) {
            const auto method = make(
                {.common = {.starts = 1}, .tolerance = 1e-2, .largest_generations = largest_generations});
            return minimize(problem, *method, {.cost = 20000}).ending;
        };
        EXPECT_EQ(ending(1), Ending::Stalled);
        EXPECT_EQ(ending(100'000), Ending::Converged);
    }
}

TEST(AnnealingThenCeres, AddsTheDescentToTheAnnealing) {
    const auto problem = rosenbrock(cube(2, -2.0, 2.0));
    const auto report =
        minimize(problem, find_optimizer("annealing-then-ceres"), {.starts = 1}, {.cost = 100000});
    EXPECT_EQ(report.ending, Ending::Converged);
    EXPECT_LT(report.value, 1e-12);
    EXPECT_GT(report.derivative_evaluations, 0);
    // A trial of the last line search may be lower by rounding than the point where the descent stops.
    EXPECT_LT((report.final_point - report.point).norm(), 1e-9);
}

TEST(SimulatedAnnealing, EndsOnItsLastAcceptedPoint) {
    const auto problem = sphere(2);
    const auto report =
        minimize(problem, find_optimizer("simulated-annealing"), {.starts = 1}, {.cost = 900});
    // Hot as it still is, it wanders: where it stands is not the best that it saw.
    EXPECT_GT(problem.value(report.final_point), report.value);
}

TEST(MethodOptions, AreRefusedWithNameValueAndBound) {
    const auto message = [](const auto& options) { return test::complaint_of([&] { options.validate(); }); };
    EXPECT_NO_THROW(SimulatedAnnealingOptions{}.validate());
    EXPECT_EQ(message(SimulatedAnnealingOptions{.largest_moves = 0}), "largest_moves: 0 must be at least 1");
    EXPECT_EQ(message(SimulatedAnnealingOptions{.initial_temperature = NAN}),
              "initial_temperature: nan must be more than 0");
    EXPECT_EQ(message(SimulatedAnnealingOptions{.cooling = 1.0}), "cooling: 1 must be below 1");
    EXPECT_EQ(message(ContinuationOptions{.smoothing = {}}), "smoothing: at least one length is needed");
    EXPECT_EQ(message(ContinuationOptions{.smoothing = {0.1, 0.2}}),
              "smoothing: 0.2 must be at most the length before it, 0.1");
    EXPECT_EQ(message(ContinuationOptions{.smoothing = {0.1, -0.2}}), "smoothing: -0.2 must be at least 0");
    EXPECT_EQ(message(MultistartOptions{.pruning_ratio = 0.5}), "pruning_ratio: 0.5 must be at least 1");
}

}  // namespace THIS_TEST
}  // namespace fretwork::optimization
