// SPDX-License-Identifier: GPL-3.0-or-later
// The tiling stage on outlines of the sizes of the paper's examples.
#include <fretwork/tiling/tessellate.hpp>
#include <fretwork/tiling/tessellation_fan.hpp>

#include <benchmark/benchmark.h>

#include <filesystem>
#include <numbers>
#include <string>

namespace fretwork::tiling {
namespace {

std::filesystem::path outline_file(const std::string& name) {
    return std::filesystem::path(FRETWORK_SOURCE_DIR) / "experiments/outlines" / name;
}

TessellationOptions paper_options(int threads) {
    TessellationOptions options;
    options.edge_length = 0.015 * std::numbers::sqrt3;  // the side of the paper's hexagon
    options.threads = threads;
    return options;
}

void read_drawing(benchmark::State& state, const std::string& name) {
    for (auto _ : state) benchmark::DoNotOptimize(read_outline(outline_file(name)));
}

void tile_drawing(benchmark::State& state, const std::string& name) {
    const Outline outline = read_outline(outline_file(name));
    const auto layout = pattern::find_node_layout("paper7");
    const TessellationOptions options = paper_options(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        const TessellationResult result = tessellate(outline, layout, options);
        state.counters["tiles"] = result.report.tiles;
    }
}

void assemble_drawing(benchmark::State& state, const std::string& name) {
    const auto layout = pattern::find_node_layout("paper7");
    TessellationResult result = tessellate(read_outline(outline_file(name)), layout, paper_options(0));
    paint_uniformly(result.tessellation, "0-1+1-6");
    for (auto _ : state) benchmark::DoNotOptimize(assemble_fans(layout, result.tessellation));
}

// The argument is the number of threads; 0 is all there are.
BENCHMARK_CAPTURE(read_drawing, b, "example_b.svg")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(tile_drawing, a, "example_a.svg")
    ->Arg(1)
    ->Arg(0)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(tile_drawing, b, "example_b.svg")
    ->Arg(1)
    ->Arg(0)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(tile_drawing, c, "example_c.svg")
    ->Arg(1)
    ->Arg(0)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(assemble_drawing, b, "example_b.svg")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fretwork::tiling
