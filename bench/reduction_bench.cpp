// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/calibration/calibration.hpp>
#include <fretwork/reduction/effective_properties.hpp>
#include <fretwork/reduction/models/condensed_tile.hpp>
#include <fretwork/reduction/ring/ring_problem.hpp>

#include <benchmark/benchmark.h>

namespace {

using namespace fretwork;
using namespace fretwork::reduction;

/// A pattern of each size in the paper's setting, with its responses.
struct Case {
    explicit Case(const char* id)
        : pattern(pattern::parse_pattern_id(layout, id)),
          responses(compute_responses(layout, pattern, setting)),
          model(setting),
          objective(responses, setting),
          problem(model, paper6_parameters(), objective, setting) {}
    pattern::NodeLayout layout = pattern::find_node_layout("paper7");
    Setting setting = paper_setting();
    pattern::Pattern pattern;
    std::vector<Response> responses;
    RingHexagon model;
    Objective objective;
    RingProblem problem;
    Eigen::VectorXd point = (Eigen::VectorXd(6) << 1.0, -0.5, 0.3, 0.2, 0.2, 0.6).finished();
};

const Case& two_edges() {
    static const Case instance("0-1+1-6");
    return instance;
}
const Case& five_edges() {
    static const Case instance("0-1+1-2+1-5+2-6+5-6");
    return instance;
}

void responses(benchmark::State& state, const Case& (*make)()) {
    const Case& c = make();
    for (auto _ : state) benchmark::DoNotOptimize(compute_responses(c.layout, c.pattern, c.setting));
}
BENCHMARK_CAPTURE(responses, two_edges, two_edges);
BENCHMARK_CAPTURE(responses, five_edges, five_edges);

void condensation(benchmark::State& state, const Case& (*make)()) {
    const Case& c = make();
    const auto polygon = geometry::regular_polygon(6, c.setting.tile_side);
    for (auto _ : state) {
        benchmark::DoNotOptimize(condensed_frame(
            pattern_frame(c.layout, c.pattern, polygon, {c.setting.section, c.setting.material}), 6));
    }
}
BENCHMARK_CAPTURE(condensation, two_edges, two_edges);
BENCHMARK_CAPTURE(condensation, five_edges, five_edges);

void homogenization(benchmark::State& state) {
    const Case& c = two_edges();
    for (auto _ : state) benchmark::DoNotOptimize(effective_properties(c.layout, c.pattern, c.setting));
}
BENCHMARK(homogenization);

void hexagon_displacements(benchmark::State& state) {
    const Case& c = two_edges();
    const RingParts parts = paper6_parameters().parts(c.problem.parameter_values(c.point));
    for (auto _ : state) benchmark::DoNotOptimize(c.model.displacements(parts));
}
BENCHMARK(hexagon_displacements);

void hexagon_derivatives(benchmark::State& state) {
    const Case& c = two_edges();
    const RingParts parts = paper6_parameters().parts(c.problem.parameter_values(c.point));
    for (auto _ : state) benchmark::DoNotOptimize(c.model.derivatives(parts, paper6_parameters().ties));
}
BENCHMARK(hexagon_derivatives);

void objective_value(benchmark::State& state) {
    const Case& c = two_edges();
    for (auto _ : state) benchmark::DoNotOptimize(c.problem.value(c.point));
}
BENCHMARK(objective_value);

void objective_gradient(benchmark::State& state) {
    const Case& c = two_edges();
    for (auto _ : state) benchmark::DoNotOptimize(c.problem.gradient(c.point, 0.0));
}
BENCHMARK(objective_gradient);

void objective_residuals(benchmark::State& state) {
    const Case& c = two_edges();
    for (auto _ : state) benchmark::DoNotOptimize(c.problem.residuals(c.point, 1e-2));
}
BENCHMARK(objective_residuals);

void objective_gradient_and_curvature(benchmark::State& state) {
    const Case& c = two_edges();
    for (auto _ : state) benchmark::DoNotOptimize(c.problem.curvature(c.point, 1e-2));
}
BENCHMARK(objective_gradient_and_curvature);

void calibration(benchmark::State& state, const char* optimizer, int starts) {
    const Case& c = two_edges();
    double objective = 0.0;
    for (auto _ : state) {
        const Calibration found =
            calibrate(find_tile_model("paper6"), {c.layout, c.pattern, c.setting, c.responses},
                      {.optimizer = optimizer, .starts = starts});
        objective = found.objective;
    }
    state.counters["E"] = objective;
}
BENCHMARK_CAPTURE(calibration, ceres_4_starts, "ceres-multistart", 4)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(calibration, gauss_newton_4_starts, "gauss-newton-multistart", 4)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(calibration, annealing, "simulated-annealing", 1)->Unit(benchmark::kMillisecond);

}  // namespace
