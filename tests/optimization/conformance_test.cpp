// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the catalogue keeps its promises, and so does a method from outside the library.
#include "analytic_problems.hpp"
#include "evolution_strategy.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/optimization/minimize.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

namespace fretwork::optimization {

/// Names the row in the message of a failed test.
void PrintTo(const OptimizerRow& row, std::ostream* stream) {
    *stream << row.name;
}

namespace THIS_TEST {

std::vector<OptimizerRow> all_rows() {
    const auto catalogue = optimizer_catalogue();
    std::vector<OptimizerRow> rows(catalogue.begin(), catalogue.end());
    rows.push_back(own::kEvolutionStrategy);
    return rows;
}

class OptimizerConformance : public testing::TestWithParam<OptimizerRow> {
  protected:
    [[nodiscard]] const OptimizerRow& row() const { return GetParam(); }
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
        EXPECT_EQ(report.ending, report.trace.empty() ? Ending::Invalid : Ending::BudgetSpent);
    }
}

TEST_P(OptimizerConformance, GivesTheSameTraceForTheSameSeed) {
    const auto problem = rosenbrock(cube(2, -2.0, 2.0));
    const auto run = [&](std::uint64_t seed) {
        return minimize(problem, row(), {.starts = 2, .seed = seed}, {.cost = 500});
    };
    const auto first = run(7);
    const auto again = run(7);
    EXPECT_EQ(first.trace, again.trace);
    EXPECT_EQ(first.point, again.point);
    const bool seed_matters = row().kind != OptimizerClass::Global;
    EXPECT_EQ(first.trace != run(8).trace, seed_matters);
}

TEST_P(OptimizerConformance, GivesTheSameTraceOnEveryThread) {
    const auto problem = rosenbrock(cube(2, -2.0, 2.0));
    const auto run = [&](std::size_t seed) {
        return minimize(problem, row(), {.starts = 2, .seed = seed}, {.cost = 500}).trace;
    };
    std::vector<std::vector<TracePoint>> at_once(8);
    base::parallel_for(at_once.size(), 4, [&](std::size_t i) { at_once[i] = run(i / 2); });
    for (std::size_t i = 0; i < at_once.size(); ++i) EXPECT_EQ(at_once[i], run(i / 2)) << "seed " << i / 2;
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

constexpr long kPlenty = 40000;

/// The targets of experiments/optimizer_comparison: what counts as success on functions whose optimum is
/// known, what does on calibrations, and the coarsest two. A method that misses them here is broken.
constexpr double kExact = 1e-6;
constexpr double kSuccess = 1e-3;
constexpr double kFair = 1e-2;
constexpr double kCoarse = 1e-1;

/// How near to the optimum of a smooth function, whose value there is 0, a method of each class must come.
double accuracy(const OptimizerRow& row) {
    // One of 40,000 uniform points in a box of side 5 is nearer to the center than sqrt(0.1); the probability
    // that none is, is (1 - 4 pi 0.1^1.5 / 3 / 125)^40000 = 4e-19.
    if (row.name == "random-search") return kCoarse;
    switch (row.kind) {
        // Descents end at steps of 1e-8 of the box: the value, which grows with their square, is off by 1e-16
        // times the box's side squared and the curvature, of up to 25 and some 1,000.
        case OptimizerClass::Local:
            return 1e-12;
        case OptimizerClass::Global:
            return kExact;
        case OptimizerClass::Random:
            break;
    }
    return kSuccess;
}

TEST_P(OptimizerConformance, SolvesTheSphere) {
    const auto problem = sphere(3);
    const auto report = minimize(problem, row(), {.starts = 4}, {.cost = kPlenty});
    EXPECT_LT(report.value, accuracy(row()));
}

TEST_P(OptimizerConformance, SolvesRosenbrock) {
    const auto problem = rosenbrock(cube(2, -2.0, 2.0));
    const auto report = minimize(problem, row(), {.starts = 4}, {.cost = kPlenty});
    EXPECT_LT(report.value, 10.0 * accuracy(row()));
}

/// The same for an optimum on a bound, as a share of its value. Two ways to keep bounds are in the catalogue
/// to show that they fall behind there, and need not be exact: Ceres cuts a dogleg's step off at the bound
/// and creeps, and the slope of a sine vanishes on it, so that Gauss-Newton steps do not see the way.
double accuracy_at_bound(const OptimizerRow& row) {
    if (row.name.ends_with("sine")) return kFair;
    if (row.name.ends_with("dogleg")) return kSuccess;
    return row.kind == OptimizerClass::Random ? kCoarse : kExact;  // random points do not lie on a bound
}

TEST_P(OptimizerConformance, FindsAnOptimumAtABound) {
    constexpr double kBest = 0.25;
    const auto problem = rosenbrock(tight_box());
    const auto report = minimize(problem, row(), {.starts = 4}, {.cost = kPlenty});
    EXPECT_NEAR(report.value, kBest, accuracy_at_bound(row()) * kBest);
}

/// Rastrigin's function as a sum of squares, with 49 minima in the box; the others are worse by at least
/// 0.99.
LeastSquaresProblem rastrigin() {
    constexpr double kPi = std::numbers::pi;
    constexpr double kRoot = 4.47213595499957939;  // of 20
    return {"rastrigin",
            {Eigen::Vector2d(-3.2, -2.7), Eigen::Vector2d(2.9, 3.6)},
            [](const Eigen::VectorXd& x) {
                return Eigen::VectorXd(
                    Eigen::Vector4d(x[0], x[1], kRoot * std::sin(kPi * x[0]), kRoot * std::sin(kPi * x[1])));
            },
            [](const Eigen::VectorXd& x) {
                Eigen::MatrixXd J = Eigen::MatrixXd::Zero(4, 2);
                J.topRows<2>().setIdentity();
                J(2, 0) = kRoot * kPi * std::cos(kPi * x[0]);
                J(3, 1) = kRoot * kPi * std::cos(kPi * x[1]);
                return J;
            }};
}

TEST_P(OptimizerConformance, FindsTheBestOfManyMinima) {
    const auto problem = rastrigin();
    const auto report = minimize(problem, row(), {.starts = 200}, {.cost = kPlenty});
    EXPECT_LT(report.value, 0.9) << "the basin of the global minimum";
}

/// Descents from several starts report the point at which their best start ended, not that of their last one.
/// A global method ends, with its budget, wherever it is.
TEST_P(OptimizerConformance, EndsInTheValleyOfItsBestPoint) {
    if (row().kind != OptimizerClass::Local) return;
    constexpr double kBetweenValleys = 0.3;
    const auto problem = two_valleys();
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const auto report = minimize(problem, row(), {.starts = 4, .seed = seed}, {.cost = 20'000});
        if (report.final_point.size() == 0) continue;  // a method that does not tell where it ended
        EXPECT_LT(problem.value(report.final_point), report.value + kBetweenValleys) << "seed " << seed;
    }
}

/// Has no value in a part of the box, as a model that cannot be solved there.
TEST_P(OptimizerConformance, CopesWithRegionsWithoutAValue) {
    const auto holed = [](const Eigen::VectorXd& x) { return x[0] > 1.0 ? NAN : 1.0; };
    const auto whole = sphere(2);
    const LeastSquaresProblem problem(
        "holed", whole.bounds(),
        [&](const Eigen::VectorXd& x) { return (holed(x) * whole.residuals(x, 0.0).residuals).eval(); },
        [&](const Eigen::VectorXd& x) { return (holed(x) * whole.residuals(x, 0.0).jacobian).eval(); });
    const auto report = minimize(problem, row(), {.starts = 10}, {.cost = 5000});
    EXPECT_GT(report.failures, 0);
    EXPECT_LT(report.value, 0.1);
    EXPECT_EQ(report.points_outside, 0);
}

TEST_P(OptimizerConformance, PassesOnWhatTheProblemThrows) {
    const LeastSquaresProblem problem(
        "throwing", cube(2, 0.0, 1.0),
        [](const auto&) -> Eigen::VectorXd { throw base::NumericalError("singular"); },
        [](const auto&) -> Eigen::MatrixXd { throw base::NumericalError("singular"); });
    EXPECT_THROW(minimize(problem, row(), {.starts = 1}, {.cost = 100}), base::NumericalError);
}

TEST_P(OptimizerConformance, RejectsOptionsThatMakeNoSense) {
    const auto problem = sphere(2);
    EXPECT_THROW(minimize(problem, row(), {.starts = 0}), base::InputError);
    EXPECT_THROW(minimize(problem, row(), {.starts = 2'000'000'000}), base::InputError);
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
    EXPECT_EQ(report.ending, Ending::Invalid);
    EXPECT_EQ(report.failures, report.evaluations);
    EXPECT_EQ(report.point.size(), 0);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, OptimizerConformance, testing::ValuesIn(all_rows()), [](const auto& row) {
    std::string name(row.param.name);
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

}  // namespace THIS_TEST
}  // namespace fretwork::optimization
