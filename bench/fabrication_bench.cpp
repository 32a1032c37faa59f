// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of making things of a surface: squares with a given number of tiles of the paper's size, painted
// with 80 patterns by chance, some 38 beams a tile.
#include <fretwork/fabrication/narrow_places.hpp>
#include <fretwork/fabrication/shape.hpp>
#include <fretwork/fabrication/sheets.hpp>
#include <fretwork/fabrication/solid.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/simulation/project/project.hpp>
#include <fretwork/tiling/painting/painting.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>

namespace fretwork::fabrication {
namespace {

const std::vector<std::string>& patterns() {
    static const std::vector<std::string> ids = [] {
        const auto layout = pattern::find_node_layout("paper7");
        const auto all = pattern::enumerate_patterns(layout, {.edges = {2, 11}, .filters = {}});
        std::vector<std::string> chosen;
        for (std::size_t i = 0; i < 80; ++i) chosen.push_back(pattern_id(layout, all[i * all.size() / 80]));
        return chosen;
    }();
    return ids;
}

const simulation::Surface& surface_of(int tiles) {
    static std::map<int, simulation::Surface> surfaces;
    const auto found = surfaces.find(tiles);
    if (found != surfaces.end()) return found->second;
    simulation::Project project;
    const double tile_side = reduction::paper_setting().tile_side;
    const double side = tile_side * std::sqrt(2.598 * tiles);
    project.outline = outlines::make_outline({{0, 0}, {side, 0}, {side, side}, {0, side}}, {});
    tiling::TessellationOptions options;
    options.edge_length = tile_side;
    project.tessellation = tiling::tessellate(project.outline, project.layout, options).tessellation;
    tiling::paint_randomly(project.tessellation, pattern::parse_named_patterns(project.layout, patterns()),
                           1);
    return surfaces.emplace(tiles, simulation::make_surface(project, nullptr)).first->second;
}

void outline(benchmark::State& state) {
    const simulation::Surface& surface = surface_of(static_cast<int>(state.range(0)));
    std::size_t openings = 0;
    for (auto _ : state) openings = make_shape(surface).pieces.front().openings.size();
    state.counters["tiles"] = static_cast<double>(surface.tessellation.tiles.size());
    state.counters["openings"] = static_cast<double>(openings);
}
BENCHMARK(outline)->Arg(500)->Arg(2000)->Unit(benchmark::kMillisecond)->UseRealTime();

void solid(benchmark::State& state) {
    const Shape shape = make_shape(surface_of(static_cast<int>(state.range(0))));
    std::size_t triangles = 0;
    for (auto _ : state) triangles = make_solid(shape).triangles.size();
    state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(solid)->Arg(500)->Arg(2000)->Unit(benchmark::kMillisecond)->UseRealTime();

void narrow(benchmark::State& state) {
    const BarPlan plan = bar_plan(surface_of(static_cast<int>(state.range(0))));
    const Shape shape = make_shape(plan, {});
    std::size_t places = 0;
    for (auto _ : state) places = narrow_places(shape, plan, 5e-4).size();
    state.counters["places"] = static_cast<double>(places);
}
BENCHMARK(narrow)->Arg(500)->Arg(2000)->Unit(benchmark::kMillisecond)->UseRealTime();

void sheets(benchmark::State& state) {
    const simulation::Surface& surface = surface_of(static_cast<int>(state.range(0)));
    std::size_t parts = 0;
    for (auto _ : state) parts = cut_into_sheets(surface, {}, {.width = 0.6, .height = 0.4}).parts;
    state.counters["parts"] = static_cast<double>(parts);
}
BENCHMARK(sheets)->Arg(500)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace fretwork::fabrication
