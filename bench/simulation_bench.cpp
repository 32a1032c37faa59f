// SPDX-License-Identifier: GPL-3.0-or-later
// Simulating a held and loaded square of tiles: building each model, solving it, and all of it together, at
// the sizes of the paper's examples (some 240 tiles) and below.
#include <fretwork/mechanics/equilibrium.hpp>
#include <fretwork/simulation/conditions.hpp>
#include <fretwork/simulation/model_catalogue.hpp>
#include <fretwork/simulation/simulate.hpp>
#include <fretwork/tiling/painting.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>

namespace fretwork::simulation {
namespace {

/// A square that about so many tiles of the paper's size cover. The calibration is made up: what a solution
/// costs does not depend on it.
const Surface& square_of(int tiles) {
    static std::map<int, Surface> surfaces;
    const auto found = surfaces.find(tiles);
    if (found != surfaces.end()) return found->second;
    const reduction::Setting setting = reduction::paper_setting();
    const double side = setting.tile_side * std::sqrt(1.5 * std::sqrt(3.0) * tiles);
    Project project;
    project.outline = tiling::make_outline({{0, 0}, {side, 0}, {side, side}, {0, side}}, {});
    tiling::TessellationOptions options;
    options.edge_length = setting.tile_side;
    project.tessellation = tiling::tessellate(project.outline, project.layout, options).tessellation;
    tiling::paint_uniformly(project.tessellation, "0-1+1-5+1-6+5-6");
    Surface surface = make_surface(project, nullptr);
    surface.calibrations.assign(1, reduction::Calibration{});
    return surfaces.emplace(tiles, std::move(surface)).first->second;
}

LoadCase cantilever() {
    LoadCase load_case;
    load_case.name = "cantilever";
    load_case.supports.push_back({NodesAtSide{Side::Left}, mechanics::DofSet::all()});
    load_case.loads.push_back({NodesAtSide{Side::Right}, {0, 0, -0.01}, {0, 0, 0}, LoadCase::Amount::Total});
    return load_case;
}

void build(benchmark::State& state, const ModelRow& model) {
    const Surface& surface = square_of(static_cast<int>(state.range(0)));
    const LoadCase load_case = cantilever();
    const Conditions conditions = resolve(load_case, surface);
    for (auto _ : state) benchmark::DoNotOptimize(model.build(surface, conditions));
    state.counters["tiles"] = static_cast<double>(surface.tessellation.tiles.size());
}

void run(benchmark::State& state, const ModelRow& model) {
    const Surface& surface = square_of(static_cast<int>(state.range(0)));
    const LoadCase load_case = cantilever();
    SimulationOptions options;
    options.model = model.name;
    for (auto _ : state) benchmark::DoNotOptimize(simulate(surface, load_case, options));
    state.counters["nodes"] = static_cast<double>(surface.fan.nodes.size());
}

[[maybe_unused]] const bool registered = [] {
    for (const ModelRow& model : model_catalogue()) {
        benchmark::RegisterBenchmark(("build_" + std::string(model.name)).c_str(),
                                     [&model](benchmark::State& state) { build(state, model); })
            ->Arg(60)
            ->Arg(240)
            ->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("simulate_" + std::string(model.name)).c_str(),
                                     [&model](benchmark::State& state) { run(state, model); })
            ->Arg(60)
            ->Arg(240)
            ->Unit(benchmark::kMillisecond);
    }
    return true;
}();

}  // namespace
}  // namespace fretwork::simulation
