// SPDX-License-Identifier: GPL-3.0-or-later
// The delay of a page: from the message of an edit to the bytes of the new positions, over the WebSocket.
// Surfaces are lattices of hexagons whose vertices are shifted by chance, so that no two tiles are congruent.
// The arguments are the number of tiles, and whether section forces are asked for.
#include "studio/running_studio.hpp"

#include <fretwork/base/random.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <benchmark/benchmark.h>

#include <cmath>

namespace fretwork::studio {
namespace {

using base::Json;
using test::Client;

const std::vector<std::string> kPatterns = {"0-1+1-6", "0-1+1-5+1-6+5-6", "0-6", "0-5+5-6", "0-1+1-3+1-6"};

/// The force at which the linear surface is deflected by 0.45 of its length: a nonlinear one by about 0.4.
double bending_force(const simulation::Project& project) {
    const simulation::SurfaceResult result = simulation::simulate(
        simulation::make_surface(project, nullptr), test::cantilever({0, 0, -1}), {.model = "condensed"});
    double length = 0.0;
    for (const geometry::Point2& point : project.tessellation.vertices) length = std::max(length, point.x);
    return 0.45 * length / result.solution.displacements.leftCols<3>().rowwise().norm().maxCoeff();
}

simulation::Project irregular(int tiles) {
    const int rows = static_cast<int>(std::lround(std::sqrt(tiles)));
    simulation::Project project = test::honeycomb((tiles + rows - 1) / rows, rows, kPatterns);
    tiling::Tessellation& tessellation = project.tessellation;
    base::RandomStream random(2, 0);
    const double reach = 0.1 * reduction::paper_setting().tile_side;
    for (geometry::Point2& vertex : tessellation.vertices) {
        vertex.x += reach * (random.uniform() - 0.5);
        vertex.y += reach * (random.uniform() - 0.5);
    }
    for (const tiling::Tile& tile : tessellation.tiles) {
        for (std::size_t k = 0; k < 6; ++k) {
            const auto& a = tessellation.vertices[tile.vertices[k]];
            const auto& b = tessellation.vertices[static_cast<std::size_t>(tile.vertices[(k + 1) % 6])];
            tessellation.interface_nodes[tile.interface_nodes[k]] = {(a.x + b.x) / 2, (a.y + b.y) / 2};
        }
    }
    project.setting = reduction::paper_setting();
    project.load_cases.push_back(test::cantilever({0, 0, -bending_force(project)}));
    return project;
}

/// Reads until the positions of the document's newest revision are there; their size in bytes.
std::size_t wait_for_positions(Client& client) {
    const std::int64_t revision = client.event({"changed"})["revision"];
    while (true) {
        const Json solved = client.event({"solved", "failed"});
        if (solved.value("provisional", false)) continue;
        if (solved["event"] == "failed") throw std::runtime_error(solved["error"].get<std::string>());
        std::string positions = client.binary();
        while (test::header(positions, 1) != 2) positions = client.binary();
        if (solved["revision"] >= revision) return positions.size();
    }
}

Json load_case(double force) {
    return Json::parse(simulation::load_case_text(test::cantilever({0, 0, -force})));
}

using Edit = std::function<void(Client& client, int round, double force)>;

void time_edits(benchmark::State& state, const char* model, const Edit& edit) {
    const auto tiles = static_cast<int>(state.range(0));
    const simulation::Project project = irregular(tiles);
    const double force = -project.load_cases.front().loads.front().force.z();
    const test::RunningStudio studio(project);
    Client client(studio.address());
    client.hello();
    (void)client.ask("set_model", {{"model", model}});
    wait_for_positions(client);
    if (state.range(1) == 0) (void)client.ask("show", {{"fields", Json::array()}});
    int round = 0;
    std::size_t bytes = 0;
    for (auto _ : state) {
        edit(client, ++round, force);
        bytes = wait_for_positions(client);
    }
    state.counters["bytes"] = static_cast<double>(bytes);
}

void dragged_load(benchmark::State& state, const char* model) {
    time_edits(state, model, [](Client& client, int round, double force) {
        (void)client.ask("set_load_case",
                         {{"index", 0},
                          {"load_case", load_case(force * (1 + 0.1 * std::sin(0.3 * round)))},
                          {"merge", "drag"}});
    });
}

void painted_tile(benchmark::State& state, const char* model) {
    const auto tiles = state.range(0);
    time_edits(state, model, [tiles](Client& client, int round, double) {
        (void)client.ask("paint",
                         {{"tiles", {7919LL * round % tiles}},
                          {"pattern", kPatterns[static_cast<std::size_t>(round) % kPatterns.size()]}});
    });
}

void arguments(benchmark::internal::Benchmark* bench) {
    for (const int tiles : {90, 560, 2000}) {
        for (const int fields : {0, 1}) bench->Args({tiles, fields});
    }
    bench->ArgNames({"tiles", "fields"})->Unit(benchmark::kMillisecond)->UseRealTime();
}
BENCHMARK_CAPTURE(dragged_load, condensed, "condensed")->Apply(arguments);
BENCHMARK_CAPTURE(dragged_load, corotational, "corotational")->Apply(arguments);
BENCHMARK_CAPTURE(dragged_load, full, "full")->Args({90, 0})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(painted_tile, condensed, "condensed")->Apply(arguments);
BENCHMARK_CAPTURE(painted_tile, corotational, "corotational")->Apply(arguments);

}  // namespace
}  // namespace fretwork::studio
