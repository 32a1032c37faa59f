// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/minimize.hpp>

#include <benchmark/benchmark.h>

namespace {

using namespace fretwork::optimization;

/// Rosenbrock's valley in six variables: as many as the paper's model has.
class Valley final : public Problem {
  public:
    [[nodiscard]] std::string name() const override { return "valley"; }
    [[nodiscard]] const Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] bool offers(Evaluation) const override { return true; }
    [[nodiscard]] double value(const Eigen::VectorXd& x) const override {
        return residuals(x, 0.0).objective;
    }
    [[nodiscard]] GradientEvaluation gradient(const Eigen::VectorXd& x, double) const override {
        const auto r = residuals(x, 0.0);
        return {r.objective, r.objective, 2.0 * r.jacobian.transpose() * r.residuals};
    }
    [[nodiscard]] ResidualEvaluation residuals(const Eigen::VectorXd& x, double) const override {
        Eigen::VectorXd r(10);
        Eigen::MatrixXd J = Eigen::MatrixXd::Zero(10, 6);
        for (Eigen::Index i = 0; i < 5; ++i) {
            r[2 * i] = 10.0 * (x[i + 1] - x[i] * x[i]);
            r[2 * i + 1] = 1.0 - x[i];
            J(2 * i, i) = -20.0 * x[i];
            J(2 * i, i + 1) = 10.0;
            J(2 * i + 1, i) = -1.0;
        }
        return {r.squaredNorm(), r, J};
    }
    [[nodiscard]] CurvatureEvaluation curvature(const Eigen::VectorXd& x, double) const override {
        const auto r = residuals(x, 0.0);
        return {r.objective, r.objective, 2.0 * r.jacobian.transpose() * r.residuals,
                2.0 * r.jacobian.transpose() * r.jacobian};
    }

  private:
    Bounds bounds_{Eigen::VectorXd::Constant(6, -2.0), Eigen::VectorXd::Constant(6, 2.0)};
};

/// The cost of a method beside the evaluations, which are nearly free here: one start, at most 1,000 of them.
void overhead(benchmark::State& state) {
    const Valley problem;
    const OptimizerRow& row = optimizer_catalogue()[static_cast<std::size_t>(state.range(0))];
    long evaluations = 0;
    for (auto _ : state) {
        const auto report = minimize(problem, row, {.starts = 1}, {.cost = 1000});
        evaluations += report.evaluations;
        benchmark::DoNotOptimize(report.value);
    }
    state.SetLabel(std::string(row.name));
    state.counters["time_per_evaluation"] = benchmark::Counter(
        static_cast<double>(evaluations), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(overhead)->DenseRange(0, static_cast<int>(optimizer_catalogue().size()) - 1);

}  // namespace
