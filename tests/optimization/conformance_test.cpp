// SPDX-License-Identifier: GPL-3.0-or-later
// What every row of the catalogue promises.
#include "analytic_problems.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/optimization/optimizer_catalogue.hpp>

#include <gtest/gtest.h>

#include <string>

namespace fretwork::optimization {
namespace {

class OptimizerConformance : public testing::TestWithParam<std::size_t> {
  protected:
    [[nodiscard]] const OptimizerRow& row() const { return optimizer_catalogue()[GetParam()]; }
};

/// Passes evaluations on, and notices whether a point is outside the bounds.
class WatchedProblem final : public Problem {
  public:
    explicit WatchedProblem(const Problem& inner) : inner_(inner) {}
    [[nodiscard]] std::string name() const override { return inner_.name(); }
    [[nodiscard]] const Bounds& bounds() const override { return inner_.bounds(); }
    [[nodiscard]] bool offers(Evaluation kind) const override { return inner_.offers(kind); }
    [[nodiscard]] long cost(Evaluation kind) const override { return kind == Evaluation::Value ? 1 : 3; }
    [[nodiscard]] double value(const Eigen::VectorXd& x) const override {
        watch(x, 1);
        return inner_.value(x);
    }
    [[nodiscard]] GradientEvaluation gradient(const Eigen::VectorXd& x, double smoothing) const override {
        watch(x, 3);
        return inner_.gradient(x, smoothing);
    }
    [[nodiscard]] ResidualEvaluation residuals(const Eigen::VectorXd& x, double smoothing) const override {
        watch(x, 3);
        return inner_.residuals(x, smoothing);
    }
    [[nodiscard]] CurvatureEvaluation curvature(const Eigen::VectorXd& x, double smoothing) const override {
        watch(x, 3);
        return inner_.curvature(x, smoothing);
    }
    [[nodiscard]] long cost_seen() const { return cost_seen_; }
    [[nodiscard]] bool left_the_bounds() const { return left_the_bounds_; }

  private:
    void watch(const Eigen::VectorXd& x, long charge) const {
        cost_seen_ += charge;
        left_the_bounds_ = left_the_bounds_ || !inner_.bounds().contain(x);
    }
    const Problem& inner_;
    mutable long cost_seen_ = 0;
    mutable bool left_the_bounds_ = false;
};

/// The optimum (1, 1) lies outside: the best point has x = 0.5 at a bound, y = x^2.
Bounds tight_box() {
    return {Eigen::Vector2d(-1.5, -1.0), Eigen::Vector2d(0.5, 2.0)};
}

TEST_P(OptimizerConformance, RespectsBoundsAndAsksForNoPointOutside) {
    const auto problem = rosenbrock(tight_box());
    const WatchedProblem watched(problem);
    const auto report = minimize(watched, row(), {.starts = 2}, {.cost = 3000});
    EXPECT_FALSE(watched.left_the_bounds());
    EXPECT_EQ(report.points_outside, 0);
    EXPECT_TRUE(problem.bounds().contain(report.point));
}

TEST_P(OptimizerConformance, NeverSpendsMoreThanTheBudgetAndReportsExactlyWhatItSpent) {
    const auto problem = rosenbrock(cube(2, -2.0, 2.0));
    for (const long budget : {1L, 2L, 7L, 40L, 333L}) {
        const WatchedProblem watched(problem);
        const auto report = minimize(watched, row(), {.starts = 50}, {.cost = budget});
        EXPECT_LE(report.cost, budget);
        EXPECT_EQ(report.cost, watched.cost_seen());
        EXPECT_GE(report.cost, budget - 2) << "50 starts want more than this: all of it is used";
        EXPECT_EQ(report.termination, report.trace.empty() ? Termination::Invalid : Termination::BudgetSpent);
    }
}

TEST_P(OptimizerConformance, GivesTheSameTraceForTheSameSeedAndAnotherForAnother) {
    const auto problem = rosenbrock(cube(2, -2.0, 2.0));
    const auto run = [&](std::uint64_t seed) {
        return minimize(problem, row(), {.starts = 2, .seed = seed}, {.cost = 500});
    };
    const auto first = run(7);
    const auto again = run(7);
    EXPECT_EQ(first.trace, again.trace);
    EXPECT_EQ(first.point, again.point);
    EXPECT_NE(first.trace, run(8).trace);
}

TEST_P(OptimizerConformance, RecordsABestSoFarThatOnlyImproves) {
    const auto problem = rosenbrock(cube(2, -2.0, 2.0));
    const auto report = minimize(problem, row(), {.starts = 3}, {.cost = 2000});
    ASSERT_FALSE(report.trace.empty());
    for (std::size_t i = 1; i < report.trace.size(); ++i) {
        EXPECT_GT(report.trace[i].cost, report.trace[i - 1].cost);
        EXPECT_LT(report.trace[i].value, report.trace[i - 1].value);
    }
    EXPECT_EQ(report.trace.back().value, report.value);
    EXPECT_EQ(problem.value(report.point), report.value);
}

/// What a method of each class reaches with 60,000 evaluations.
double sphere_target(OptimizerClass kind, std::string_view name) {
    if (name == "random-search") return 0.1;
    return kind == OptimizerClass::Random ? 1e-4 : 1e-12;
}

TEST_P(OptimizerConformance, SolvesTheSphere) {
    const auto problem = sphere(3);
    const auto report = minimize(problem, row(), {.starts = 1}, {.cost = 60000});
    EXPECT_LT(report.value, sphere_target(row().kind, row().name));
}

TEST_P(OptimizerConformance, SolvesRosenbrock) {
    const auto problem = rosenbrock(cube(2, -2.0, 2.0));
    const auto report = minimize(problem, row(), {.starts = 2}, {.cost = 60000});
    EXPECT_LT(report.value, row().kind == OptimizerClass::Random ? 1e-2 : 1e-8);
}

TEST_P(OptimizerConformance, FindsAnOptimumAtABound) {
    const auto problem = rosenbrock(tight_box());
    const auto report = minimize(problem, row(), {.starts = 2}, {.cost = 60000});
    EXPECT_NEAR(report.value, 0.25, row().kind == OptimizerClass::Random ? 1e-2 : 1e-6);
}

TEST_P(OptimizerConformance, RejectsOptionsThatMakeNoSense) {
    const auto problem = sphere(2);
    EXPECT_THROW(minimize(problem, row(), {.starts = 0}), base::InputError);
    EXPECT_THROW(minimize(problem, row(), {}, {.cost = 0}), base::InputError);
    EXPECT_THROW(minimize(problem, row(), {}, {.cost = 10, .seconds = -1.0}), base::InputError);
}

/// Offers values only.
class ValueOnly final : public Problem {
  public:
    explicit ValueOnly(double value) : value_(value) {}
    [[nodiscard]] std::string name() const override { return "value-only"; }
    [[nodiscard]] const Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] double value(const Eigen::VectorXd&) const override { return value_; }

  private:
    Bounds bounds_ = cube(2, 0.0, 1.0);
    double value_;
};

TEST_P(OptimizerConformance, IsRefusedByAProblemThatDoesNotOfferWhatItNeeds) {
    const ValueOnly problem(1.0);
    if (problem.offers(row().needs)) {
        EXPECT_EQ(minimize(problem, row(), {}, {.cost = 50}).value, 1.0);
    } else {
        EXPECT_THROW(minimize(problem, row(), {}, {.cost = 50}), base::InputError);
    }
}

TEST_P(OptimizerConformance, SaysInvalidWhereTheObjectiveIsNowhereFinite) {
    const auto problem = LeastSquaresProblem(
        "nan", cube(2, 0.0, 1.0), [](const auto&) { return Eigen::VectorXd::Constant(2, NAN).eval(); },
        [](const auto&) { return Eigen::MatrixXd::Constant(2, 2, NAN).eval(); });
    const auto report = minimize(problem, row(), {.starts = 1}, {.cost = 200});
    EXPECT_EQ(report.termination, Termination::Invalid);
    EXPECT_EQ(report.failures, report.evaluations);
    EXPECT_EQ(report.point.size(), 0);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, OptimizerConformance,
                         testing::Range<std::size_t>(0, optimizer_catalogue().size()), [](const auto& row) {
                             std::string name(optimizer_catalogue()[row.param].name);
                             std::erase(name, '-');
                             return name;
                         });

TEST(OptimizerCatalogue, NamesTheNearestMethod) {
    try {
        (void)find_optimizer("random-serch");
        FAIL();
    } catch (const base::InputError& error) {
        EXPECT_NE(std::string(error.what()).find("random-search"), std::string::npos);
    }
}

}  // namespace
}  // namespace fretwork::optimization
