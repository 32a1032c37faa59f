// SPDX-License-Identifier: GPL-3.0-or-later
// The tiling stage on outlines of the sizes of the paper's examples.
#include <fretwork/outlines/outline.hpp>
#include <fretwork/tiling/tessellate.hpp>
#include <fretwork/tiling/tessellation_fan.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <numbers>
#include <stop_token>
#include <string>
#include <thread>

namespace fretwork::tiling {
namespace {

using Clock = std::chrono::steady_clock;

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
    for (auto _ : state) benchmark::DoNotOptimize(outlines::read_outline(outline_file(name)));
}

void tile_drawing(benchmark::State& state, const std::string& name) {
    const outlines::Outline outline = outlines::read_outline(outline_file(name));
    const auto layout = pattern::find_node_layout("paper7");
    const TessellationOptions options = paper_options(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        const TessellationResult result = tessellate(outline, layout, options);
        state.counters["tiles"] = result.report.tiles;
    }
}

void assemble_drawing(benchmark::State& state, const std::string& name) {
    const auto layout = pattern::find_node_layout("paper7");
    TessellationResult result =
        tessellate(outlines::read_outline(outline_file(name)), layout, paper_options(0));
    paint_uniformly(result.tessellation, pattern::parse_named_pattern(layout, "0-1+1-6"));
    for (auto _ : state) benchmark::DoNotOptimize(assemble_fans(layout, result.tessellation));
}

/// From the request to stop to the return, after the given milliseconds of work on tiles of the given
/// millimetres: 5 are 14,000 tiles, 2 are 86,000.
void stop_tiling(benchmark::State& state) {
    const outlines::Outline outline = outlines::read_outline(outline_file("example_b.svg"));
    const auto layout = pattern::find_node_layout("paper7");
    double longest = 0.0;
    for (auto _ : state) {
        std::stop_source source;
        TessellationOptions options{.edge_length = 1e-3 * static_cast<double>(state.range(1)),
                                    .control = {.stop = source.get_token()}};
        Clock::time_point asked;
        std::jthread asking([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(state.range(0)));
            asked = Clock::now();
            source.request_stop();
        });
        try {
            (void)tessellate(outline, layout, options);
        } catch (const base::Stopped&) {
            const double seconds = std::chrono::duration<double>(Clock::now() - asked).count();
            state.SetIterationTime(seconds);
            longest = std::max(longest, seconds);
        }
    }
    state.counters["longest_ms"] = 1e3 * longest;
}
BENCHMARK(stop_tiling)
    ->ArgsProduct({benchmark::CreateDenseRange(200, 3200, 500), {5, 2}})
    ->UseManualTime()
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);

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
