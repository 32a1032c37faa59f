// SPDX-License-Identifier: GPL-3.0-or-later
// Writing a surface of the size of the paper's example A (about 240 tiles) and of ten times as many.
#include <fretwork/exports/writer_catalogue.hpp>
#include <fretwork/tiling/tessellate.hpp>

#include <benchmark/benchmark.h>

#include <map>

namespace fretwork::exports {
namespace {

/// A square of about `tiles` tiles of the paper's size, with made-up displacements.
const Scene& scene_of(int tiles) {
    static std::map<int, Scene> scenes;
    const auto found = scenes.find(tiles);
    if (found != scenes.end()) return found->second;
    const reduction::Setting setting = reduction::paper_setting();
    const double side = setting.tile_side * std::sqrt(2.598 * tiles);
    simulation::Project project;
    project.outline = outlines::make_outline({{0, 0}, {side, 0}, {side, side}, {0, side}}, {});
    tiling::TessellationOptions options;
    options.edge_length = setting.tile_side;
    project.tessellation = tiling::tessellate(project.outline, project.layout, options).tessellation;
    const std::vector<std::string> patterns = {"0-1+1-6", "1-6+3-6", "0-1+0-6+1-6"};
    tiling::paint_randomly(project.tessellation, pattern::parse_named_patterns(project.layout, patterns), 1);
    Scene scene{simulation::make_surface(project, nullptr)};
    simulation::SurfaceResult result;
    const auto nodes = simulation::surface_fan(scene.surface).nodes;
    result.solution.displacements =
        mechanics::NodeValues::Random(static_cast<Eigen::Index>(nodes.size()), 6) * 1e-3;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        result.nodes.push_back({static_cast<int>(i),
                                {nodes[i].x, nodes[i].y, 0.0},
                                i < scene.surface.tessellation.interface_nodes.size()});
    }
    scene.results.push_back({"made up", result});
    return scenes.emplace(tiles, std::move(scene)).first->second;
}

void write_text(benchmark::State& state, const WriterRow& writer) {
    const Scene& scene = scene_of(static_cast<int>(state.range(0)));
    std::size_t bytes = 0;
    for (auto _ : state) bytes = writer.write(scene).text.size();
    state.counters["MB"] = static_cast<double>(bytes) * 1e-6;
}

[[maybe_unused]] const bool registered = [] {
    for (const WriterRow& writer : writer_catalogue()) {
        benchmark::RegisterBenchmark(
            ("write_" + std::string(content_name(writer.content)) + std::string(writer.ending)).c_str(),
            [&writer](benchmark::State& state) { write_text(state, writer); })
            ->Arg(240)
            ->Arg(2400)
            ->Unit(benchmark::kMillisecond);
    }
    return true;
}();

}  // namespace
}  // namespace fretwork::exports
