// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated annealing beside the trace that annealing_trace.py writes from the published description.
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/methods/simulated_annealing.hpp>
#include <fretwork/optimization/minimize.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace fretwork::optimization {
namespace THIS_TEST {

/// The quadratic of annealing_trace.py; it remembers every point.
class Quadratic final : public Problem {
  public:
    [[nodiscard]] std::string name() const override { return "quadratic"; }
    [[nodiscard]] const Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] double value(const Eigen::VectorXd& x) const override {
        points.push_back(x);
        return 10.0 * (x - Eigen::Vector2d(0.3, 0.7)).squaredNorm();
    }
    mutable std::vector<Eigen::VectorXd> points;

  private:
    Bounds bounds_{Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1.0, 1.0)};
};

struct Step {
    std::size_t move;
    Eigen::Vector2d proposal;
};

std::vector<Step> read_trace(const std::string& wanted_case) {
    std::vector<Step> steps;
    const std::string text =
        base::read_text_file(FRETWORK_SOURCE_DIR "/tests/optimization/annealing_trace.csv");
    for (const std::string& line : base::split(text, '\n')) {
        const auto cells = base::split(line, ',');
        if (cells.front() != wanted_case) continue;
        steps.push_back({std::stoul(cells.at(1)), {std::stod(cells.at(2)), std::stod(cells.at(3))}});
    }
    return steps;
}

/// An acceptance that differs, or a temperature, changes the next proposals. The two programs round alike but
/// for the last digits.
void expect_equal_proposals(const std::vector<Step>& expected, const Quadratic& problem) {
    ASSERT_FALSE(expected.empty());
    for (const Step& step : expected) {
        ASSERT_LT(step.move, problem.points.size());
        ASSERT_LT((problem.points[step.move] - step.proposal).norm(), 1e-12) << "move " << step.move;
    }
}

TEST(AnnealingTrace, FollowsThePublishedAlgorithmMoveByMove) {
    const Quadratic problem;
    const auto annealing = make_simulated_annealing({.common = {.starts = 1, .seed = 5},
                                                     .initial_temperature = 10.0,
                                                     .initial_moves = 40,
                                                     .cooling = 0.02,
                                                     .sweeps_per_adaptation = 10});
    (void)minimize(problem, *annealing, {.cost = 301});
    const auto trace = read_trace("short");
    ASSERT_EQ(trace.size(), 300U);
    expect_equal_proposals(trace, problem);
}

TEST(AnnealingTrace, FreezesWhereThePublishedDefaultsFreeze) {
    const Quadratic problem;
    const auto report = minimize(problem, find_optimizer("simulated-annealing"), {.starts = 1, .seed = 11},
                                 {.cost = 1'000'000});
    const auto trace = read_trace("default");
    expect_equal_proposals(trace, problem);
    EXPECT_EQ(report.ending, Ending::Converged);
    EXPECT_EQ(static_cast<std::size_t>(report.evaluations), trace.back().move + 1);
}

}  // namespace THIS_TEST
}  // namespace fretwork::optimization
