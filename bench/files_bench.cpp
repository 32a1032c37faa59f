// SPDX-License-Identifier: GPL-3.0-or-later
// Reading and writing of the files that grow with a structure, beside the linear solve of the same structure.
#include <fretwork/base/files/file.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/results/result_file.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>

namespace fretwork {
namespace {

using mechanics::Frame;

/// A honeycomb of about the given number of nodes, held at its left rim and loaded at the right.
Frame honeycomb(std::int64_t nodes) {
    constexpr double kSide = 0.0123456789;
    const int columns = 2 * static_cast<int>(std::sqrt(static_cast<double>(nodes)) / 2);
    const int rows = static_cast<int>(nodes) / columns;
    const mechanics::Material material{.young_modulus = 2e9, .poisson_ratio = 0.35};
    const mechanics::Section section = mechanics::rectangle_section(0.002, 0.002);
    Frame frame;
    const auto add_beam = [&](int from, int to) {
        frame.beams.push_back({.nodes = {mechanics::NodeIndex(from), mechanics::NodeIndex(to)},
                               .section = section,
                               .material = material});
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int node = row * columns + column;
            const bool is_upper = (row + column) % 2 == 1;
            frame.nodes.emplace_back(column * kSide * std::sqrt(0.75),
                                     kSide * (1.5 * row + (is_upper ? 0.5 : 0)), 1e-3 * std::sin(0.1 * node));
            if (column + 1 < columns) add_beam(node, node + 1);
            if (row + 1 < rows && is_upper) add_beam(node, node + columns);
        }
        frame.supports.push_back({mechanics::NodeIndex(row * columns), mechanics::DofSet::all()});
        frame.loads.push_back({mechanics::NodeIndex((row + 1) * columns - 1), {0, 0, -1e-6}, {0, 0, 0}});
    }
    return frame;
}

mechanics::Result solved(const Frame& frame) {
    mechanics::Result result;
    result.solver = "linear";
    for (std::size_t i = 0; i < frame.nodes.size(); ++i)
        result.nodes.push_back({static_cast<int>(i), frame.nodes[i], false});
    result.solution = mechanics::solve_linear(mechanics::assemble(frame));
    return result;
}

/// A file that vanishes with it.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::string& name) : path_(std::filesystem::temp_directory_path() / name) {}
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

void solve_linear(benchmark::State& state) {
    const Frame frame = honeycomb(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(mechanics::solve_linear(mechanics::assemble(frame)));
}

void read_frame(benchmark::State& state) {
    const TemporaryFile file("fretwork_files_bench_frame.json");
    mechanics::write_frame(honeycomb(state.range(0)), file.path());
    for (auto _ : state) benchmark::DoNotOptimize(mechanics::read_frame(file.path()));
}

void write_frame(benchmark::State& state) {
    const Frame frame = honeycomb(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(mechanics::frame_text(frame));
}

void read_result(benchmark::State& state) {
    const TemporaryFile file("fretwork_files_bench_result.json");
    mechanics::write_result(solved(honeycomb(state.range(0))), file.path());
    for (auto _ : state) benchmark::DoNotOptimize(mechanics::read_result(file.path()));
}

void write_result(benchmark::State& state) {
    const mechanics::Result result = solved(honeycomb(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(mechanics::result_text(result));
}

simulation::Project project_of(std::int64_t tiles) {
    constexpr double kTileSide = 0.026;
    const double side = kTileSide * std::sqrt(2.598 * static_cast<double>(tiles));
    simulation::Project project;
    project.layout = pattern::find_node_layout("paper7");
    project.outline = outlines::make_outline({{0, 0}, {side, 0}, {side, side}, {0, side}}, {});
    project.tessellation =
        tiling::tessellate(project.outline, project.layout, {.edge_length = kTileSide}).tessellation;
    return project;
}

void read_project(benchmark::State& state) {
    const TemporaryFile file("fretwork_files_bench_project.json");
    simulation::write_project(project_of(state.range(0)), file.path());
    for (auto _ : state) benchmark::DoNotOptimize(simulation::read_project(file.path()));
}

void write_project(benchmark::State& state) {
    const TemporaryFile file("fretwork_files_bench_project.json");
    const simulation::Project project = project_of(state.range(0));
    for (auto _ : state) simulation::write_project(project, file.path());
}

void sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->Arg(100)->Arg(1000)->Arg(10000)->Arg(50000)->Arg(200000)->Unit(benchmark::kMillisecond);
}

BENCHMARK(solve_linear)->Apply(sizes);
BENCHMARK(read_frame)->Apply(sizes);
BENCHMARK(write_frame)->Apply(sizes);
BENCHMARK(read_result)->Apply(sizes);
BENCHMARK(write_result)->Apply(sizes);
BENCHMARK(read_project)->Arg(500)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(write_project)->Arg(500)->Arg(10000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fretwork
