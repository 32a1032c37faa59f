// SPDX-License-Identifier: GPL-3.0-or-later
#include "analytic_problems.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/optimization/minimize.hpp>

#include <gtest/gtest.h>

#include <stop_token>

namespace fretwork::optimization {
namespace THIS_TEST {

/// Asks to stop once a method has spent so much.
class StopAtCost final : public base::Progress {
  public:
    explicit StopAtCost(std::size_t cost) : cost_(cost) {}
    void start(std::string_view, std::size_t) override {}
    void update(std::size_t cost) override {
        last = cost;
        if (cost >= cost_) source.request_stop();
    }
    void finish() override { is_finished = true; }
    std::stop_source source;
    std::size_t last = 0;
    bool is_finished = false;

  private:
    std::size_t cost_;
};

TEST(Minimize, StopsBeforeTheNextEvaluationWhicheverTheMethod) {
    const auto problem = rosenbrock(cube(2, -2.0, 2.0));
    for (const OptimizerRow& row : optimizer_catalogue()) {
        StopAtCost progress(10);
        const base::Control control{.stop = progress.source.get_token(), .progress = &progress};
        EXPECT_THROW(minimize(problem, row, {.starts = 50}, {.cost = 5000, .control = control}),
                     base::Stopped)
            << row.name;
        EXPECT_EQ(progress.last, 10U) << row.name;
    }
}

TEST(Minimize, TellsWhatItSpends) {
    const auto problem = sphere(2);
    StopAtCost progress(1'000'000);
    const auto report = minimize(problem, find_optimizer("bobyqa"), {}, {.control = {.progress = &progress}});
    EXPECT_EQ(progress.last, static_cast<std::size_t>(report.cost));
    EXPECT_TRUE(progress.is_finished);
}

TEST(Minimize, RefusesAMethodThatNeedsTheJacobianThatIsNotThere) {
    const LeastSquaresProblem problem("values", cube(2, -1.0, 1.0),
                                      [](const Eigen::VectorXd& x) { return x; }, {});
    EXPECT_TRUE(problem.offers(Evaluation::Value));
    EXPECT_FALSE(problem.offers(Evaluation::Residuals));
    EXPECT_THROW((void)minimize(problem, find_optimizer("slsqp")), base::InputError);
    const Eigen::VectorXd point = Eigen::VectorXd::Zero(2);
    EXPECT_THROW((void)problem.gradient(point, 0.0), base::NumericalError);
    EXPECT_THROW((void)problem.residuals(point, 0.0), base::NumericalError);
    EXPECT_THROW((void)problem.curvature(point, 0.0), base::NumericalError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::optimization
