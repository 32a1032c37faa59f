// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of edits of a surface beside solving it from nothing. The surfaces are lattices of hexagons of the
// paper's size, painted with 24 patterns by chance: `equal` ones, whose tiles are congruent, and `irregular`
// ones, whose vertices are shifted by chance, so that no two tiles are. The argument is the number of tiles.
// Rows `bent_*` of corotational tiles also say how many factorizations of the same tangent, made in the same
// run on one thread, would take as long (`factorizations`): that differs little from machine to machine.
#include <fretwork/base/random.hpp>
#include <fretwork/geometry/point_grid.hpp>
#include <fretwork/mechanics/nonlinear/nonlinear_system.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/simulation/derivatives/sensitivity.hpp>
#include <fretwork/simulation/detail/joined_tiles.hpp>
#include <fretwork/simulation/session.hpp>
#include <fretwork/simulation/simulate.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

namespace fretwork::simulation {
namespace {

enum class Lattice { Equal, Irregular };

/// Points nearer to each other than this are one, m.
constexpr double kSame = 1e-6;

const std::vector<std::string>& patterns() {
    static const std::vector<std::string> ids = [] {
        const auto layout = pattern::find_node_layout("paper7");
        const auto all = pattern::enumerate_patterns(layout, {.edges = {2, 5}, .filters = {}});
        std::vector<std::string> chosen;
        for (std::size_t i = 0; i < 24; ++i) chosen.push_back(pattern_id(layout, all[i * all.size() / 24]));
        return chosen;
    }();
    return ids;
}

tiling::Tessellation hexagons(int count, double side) {
    const int rows = static_cast<int>(std::lround(std::sqrt(count)));
    const geometry::Polygon hexagon = geometry::regular_polygon(6, side);
    tiling::Tessellation tessellation;
    tessellation.layout = "paper7";
    tessellation.patterns = pattern::parse_named_patterns(pattern::find_node_layout("paper7"), patterns());
    base::RandomStream random(1, 0);
    geometry::PointGrid vertices(kSame);
    for (int i = 0; i < count; ++i) {
        const int column = i / rows;
        const double x = 1.5 * side * column;
        const double y = std::sqrt(3.0) * side * (i % rows + 0.5 * (column % 2));
        tiling::Tile tile;
        tile.pattern = static_cast<int>(random.uniform() * 24.0);
        for (const geometry::Point2& vertex : hexagon)
            tile.vertices.emplace_back(vertices.number_of({x + vertex.x, y + vertex.y}, kSame));
        tessellation.tiles.push_back(std::move(tile));
    }
    tessellation.vertices = vertices.points();
    return tessellation;
}

void place_interface_nodes(tiling::Tessellation& tessellation) {
    geometry::PointGrid nodes(kSame);
    for (tiling::Tile& tile : tessellation.tiles) {
        for (std::size_t k = 0; k < 6; ++k) {
            const auto& a = tessellation.vertices[tile.vertices[k]];
            const auto& b = tessellation.vertices[static_cast<std::size_t>(tile.vertices[(k + 1) % 6])];
            tile.interface_nodes.emplace_back(nodes.number_of({(a.x + b.x) / 2, (a.y + b.y) / 2}, kSame));
        }
    }
    tessellation.interface_nodes = nodes.points();
}

const Surface& surface_of(Lattice lattice, int tiles) {
    static std::map<std::pair<Lattice, int>, Surface> surfaces;
    const auto found = surfaces.find({lattice, tiles});
    if (found != surfaces.end()) return found->second;
    const double side = reduction::paper_setting().tile_side;
    Project project;
    project.tessellation = hexagons(tiles, side);
    base::RandomStream random(2, 0);
    for (geometry::Point2& vertex : project.tessellation.vertices) {
        const double reach = lattice == Lattice::Equal ? 0.0 : 0.1 * side;
        vertex.x += reach * (random.uniform() - 0.5);
        vertex.y += reach * (random.uniform() - 0.5);
    }
    place_interface_nodes(project.tessellation);
    return surfaces.emplace(std::pair(lattice, tiles), make_surface(project, nullptr)).first->second;
}

LoadCase cantilever(double force = 0.01) {
    LoadCase load_case;
    load_case.name = "cantilever";
    load_case.supports.push_back({NodesAtSide{Side::Left}, mechanics::DofSet::all()});
    load_case.loads.push_back({NodesAtSide{Side::Right}, {0, 0, -force}, {0, 0, 0}, LoadCase::Amount::Total});
    return load_case;
}

Session session_of(benchmark::State& state, Lattice lattice) {
    const Surface& surface = surface_of(lattice, static_cast<int>(state.range(0)));
    state.counters["nodes"] = static_cast<double>(surface.tessellation.interface_nodes.size());
    return {surface, cantilever(), {.model = "condensed"}};
}

/// Solve, edit and solve again, and so on: what the second and later solutions cost, with the edit.
template <class Edit>
void time_edits(benchmark::State& state, Lattice lattice, const Edit& edit) {
    Session session = session_of(state, lattice);
    benchmark::DoNotOptimize(session.solve());
    int round = 0;
    for (auto _ : state) {
        edit(session, ++round);
        benchmark::DoNotOptimize(session.solve());
    }
    state.counters["tiles_built"] = static_cast<double>(session.last_report().tiles_built);
    state.counters["factors_updated"] = session.last_report().factors == Session::Report::Factors::Updated;
}

void from_nothing(benchmark::State& state, Lattice lattice) {
    const Surface& surface = surface_of(lattice, static_cast<int>(state.range(0)));
    const LoadCase load_case = cantilever();
    for (auto _ : state) {
        Session session(surface, load_case, {.model = "condensed"});
        benchmark::DoNotOptimize(session.solve());
        state.counters["tiles_built"] = static_cast<double>(session.last_report().tiles_built);
    }
}

void new_load(benchmark::State& state, Lattice lattice) {
    time_edits(state, lattice, [](Session& session, int round) {
        session.set_load_case(cantilever(0.01 * (round % 7 + 1)));
    });
}

void moved_support(benchmark::State& state, Lattice lattice) {
    const auto nodes = static_cast<int>(
        surface_of(lattice, static_cast<int>(state.range(0))).tessellation.interface_nodes.size());
    time_edits(state, lattice, [nodes](Session& session, int round) {
        const int node = nodes / 2 + round % 50;
        session.set_support(1, {NodesById{{node}}, mechanics::DofSet::translations()});
    });
}

void repainted_tile(benchmark::State& state, Lattice lattice) {
    const auto count = static_cast<int>(state.range(0));
    time_edits(state, lattice, [count](Session& session, int round) {
        // Another tile each time, so that an irregular one is built; from anywhere in the surface.
        const tiling::TileIndex tile(static_cast<int>(static_cast<long long>(round) * 7919 % count));
        session.paint({&tile, 1}, patterns()[static_cast<std::size_t>(round % 24)]);
    });
}

void new_material(benchmark::State& state, Lattice lattice) {
    time_edits(state, lattice, [](Session& session, int round) {
        reduction::Setting setting = session.surface().setting;
        setting.material.young_modulus = 1e9 * (1.0 + 0.1 * (round % 7));
        session.set_setting(setting);
    });
}

void sizes(benchmark::internal::Benchmark* bench) {
    for (const int tiles : {100, 500, 2000, 10000}) bench->Arg(tiles);
    bench->Unit(benchmark::kMillisecond)->UseRealTime();
}
#define FRETWORK_EDIT(name)                                               \
    BENCHMARK_CAPTURE(name, irregular, Lattice::Irregular)->Apply(sizes); \
    BENCHMARK_CAPTURE(name, equal, Lattice::Equal)->Apply(sizes)
FRETWORK_EDIT(from_nothing);
FRETWORK_EDIT(new_load);
FRETWORK_EDIT(moved_support);
FRETWORK_EDIT(repainted_tile);
FRETWORK_EDIT(new_material);

// ---- large displacements: a cantilever bent to about two fifths of its span ----

const Surface& irregular(const benchmark::State& state) {
    return surface_of(Lattice::Irregular, static_cast<int>(state.range(0)));
}

/// The force at which the linear surface is deflected by 0.45 of its length: the nonlinear one by 0.4.
double bending_force(const Surface& surface) {
    static std::map<const Surface*, double> forces;
    if (const auto found = forces.find(&surface); found != forces.end()) return found->second;
    const simulation::SurfaceResult result = simulate(surface, cantilever(1.0), {.model = "condensed"});
    double length = 0.0;
    for (const geometry::Point2& point : surface.tessellation.vertices) length = std::max(length, point.x);
    return forces[&surface] =
               0.45 * length / result.solution.displacements.leftCols<3>().rowwise().norm().maxCoeff();
}

/// Of all threads: others may keep the machine busy.
double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Of the tangent of a surface of corotational tiles at rest, on one thread: the best of nine.
double seconds_of_factorization(const Surface& surface) {
    static std::map<const Surface*, double> seconds;
    if (const auto found = seconds.find(&surface); found != seconds.end()) return found->second;
    const ModelChoice choice{.name = "corotational"};
    const auto tiles = detail::TileBuilder().build_all(surface, choice, {});
    mechanics::Assembly assembly = reduction::assemble(detail::join_tiles(surface, tiles, {}).parts);
    assembly.supports.push_back({mechanics::NodeIndex(0), mechanics::DofSet::all()});
    mechanics::nonlinear::NonlinearSystem system(assembly);
    system.evaluate(system.unknowns().rest(), 0.0);
    mechanics::sparse::Ldlt factors(system.unknowns().layout());
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 10; ++i) {
        const double start = processor_seconds();
        benchmark::DoNotOptimize(factors.factorize(system.tangent()));
        if (i > 0) best = std::min(best, processor_seconds() - start);  // the first one meets new memory
    }
    return seconds[&surface] = best;
}

/// Counts a row's processor time in factorizations.
void count_factorizations(benchmark::State& state, const char* model, double start) {
    const double each = (processor_seconds() - start) / static_cast<double>(state.iterations());
    if (std::string_view(model) == "corotational")
        state.counters["factorizations"] = each / seconds_of_factorization(irregular(state));
}

void bent_factorization(benchmark::State& state) {
    for (auto _ : state) state.SetIterationTime(seconds_of_factorization(irregular(state)));
}

void bent_linear(benchmark::State& state, const char* model) {
    const Surface& surface = irregular(state);
    const LoadCase load_case = cantilever(bending_force(surface));
    for (auto _ : state)
        benchmark::DoNotOptimize(
            simulate(surface, load_case, {.model = model, .analysis = Analysis::Linear}));
}

void bent_from_rest(benchmark::State& state, const char* model) {
    const Surface& surface = irregular(state);
    const LoadCase load_case = cantilever(bending_force(surface));
    const double start = processor_seconds();
    for (auto _ : state) {
        const simulation::SurfaceResult result = simulate(surface, load_case, {.model = model});
        state.counters["iterations"] = result.solution.iterations;
        state.counters["residual"] = result.solution.residual;
        state.counters["converged"] = result.solution.converged();
    }
    count_factorizations(state, model, start);
}

/// Solve, edit and solve again from the last equilibrium, and so on.
template <class Edit>
void time_bent_edits(benchmark::State& state, const char* model, const Edit& edit,
                     mechanics::StabilityCheck check = mechanics::StabilityCheck::Made) {
    const Surface& surface = irregular(state);
    Session session(surface, cantilever(bending_force(surface)), {.model = model});
    benchmark::DoNotOptimize(session.solve());
    int round = 0;
    double from_last = 0.0;
    const double start = processor_seconds();
    for (auto _ : state) {
        edit(session, ++round);
        benchmark::DoNotOptimize(session.solve({}, check));
        from_last += session.last_report().starting_point == mechanics::StartingPoint::LastEquilibrium;
    }
    state.counters["from_last"] = from_last / round;
    count_factorizations(state, model, start);
}

/// The load changed by this share.
auto move_load(double force, double share) {
    return [force, share](Session& session, int round) {
        session.set_load_case(cantilever(force * (round % 2 == 0 ? 1.0 : 1.0 + share)));
    };
}

void bent_new_load(benchmark::State& state, const char* model) {
    time_bent_edits(state, model, move_load(bending_force(irregular(state)), 0.1));
}

void bent_little_load(benchmark::State& state, const char* model) {
    time_bent_edits(state, model, move_load(bending_force(irregular(state)), 0.01));
}

/// The same while it is dragged: nothing is asked of stability.
void bent_dragged_load(benchmark::State& state, const char* model) {
    time_bent_edits(state, model, move_load(bending_force(irregular(state)), 0.01),
                    mechanics::StabilityCheck::Skipped);
}

void bent_repainted_tile(benchmark::State& state, const char* model) {
    const auto count = static_cast<int>(state.range(0));
    time_bent_edits(state, model, [count](Session& session, int round) {
        const tiling::TileIndex tile(static_cast<int>(static_cast<long long>(round) * 7919 % count));
        session.paint({&tile, 1}, patterns()[static_cast<std::size_t>(round % 24)]);
    });
}

/// The same cantilever with a node held as well, at its place at rest: in turn one at a third and one at two
/// thirds of the nodes, so that each has moved away when it comes to be held. `of_from_nothing`: the time as
/// a share of that of sessions which begin with these supports.
void bent_moved_support(benchmark::State& state, const char* model) {
    const Surface& surface = irregular(state);
    const auto nodes = static_cast<int>(surface.tessellation.interface_nodes.size());
    const auto held = [&](int node) {
        LoadCase load_case = cantilever(bending_force(surface));
        load_case.supports.push_back({NodesById{{node}}, mechanics::DofSet::translations()});
        return load_case;
    };
    const LoadCase cases[] = {held(nodes / 3), held(2 * nodes / 3)};
    const double from_nothing = processor_seconds();
    for (const LoadCase& load_case : cases)
        benchmark::DoNotOptimize(simulate(surface, load_case, {.model = model}));
    const double each_from_nothing = 0.5 * (processor_seconds() - from_nothing);
    Session session(surface, cases[0], {.model = model});
    benchmark::DoNotOptimize(session.solve());
    int round = 0;
    const double start = processor_seconds();
    for (auto _ : state) {
        session.set_load_case(cases[++round % 2]);
        benchmark::DoNotOptimize(session.solve());
    }
    state.counters["of_from_nothing"] = (processor_seconds() - start) / round / each_from_nothing;
    count_factorizations(state, model, start);
}

/// What the derivatives of the mean deflection by all tiles x 64 patterns cost after a solution;
/// `solution_ms` is that solution's, from rest. The candidates are condensed once, before.
void bent_pattern_derivatives(benchmark::State& state, Lattice lattice) {
    const Surface& surface = surface_of(lattice, static_cast<int>(state.range(0)));
    const auto layout = pattern::find_node_layout("paper7");
    const auto all = pattern::enumerate_patterns(layout, {.edges = {2, 5}, .filters = {}});
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < 64; ++i) ids.push_back(pattern_id(layout, all[i * all.size() / 64]));
    const CandidateTiles candidates(surface, pattern::parse_named_patterns(layout, ids));
    Session session(surface, cantilever(bending_force(surface)), {.model = "corotational"});
    const SurfaceResult result = session.solve();
    mechanics::NodeValues gradient =
        mechanics::NodeValues::Zero(result.solution.displacements.rows(), mechanics::kDofsPerNode);
    gradient.col(2).setOnes();
    for (auto _ : state)
        benchmark::DoNotOptimize(pattern_derivatives(session.sensitivity(gradient), candidates).data());
    state.counters["solution_ms"] = 1e3 * result.seconds;
}

/// The second time is processor time of all threads: others may keep the machine busy.
void bent_sizes(benchmark::internal::Benchmark* bench) {
    for (const int tiles : {100, 500, 2000, 10000}) bench->Arg(tiles);
    bench->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
}
#define FRETWORK_BENT(name)                                                   \
    BENCHMARK_CAPTURE(name, corotational, "corotational")->Apply(bent_sizes); \
    BENCHMARK_CAPTURE(name, full, "full")->Apply(bent_sizes)
BENCHMARK_CAPTURE(bent_linear, condensed, "condensed")->Apply(bent_sizes);
BENCHMARK_CAPTURE(bent_linear, full, "full")->Apply(bent_sizes);
FRETWORK_BENT(bent_from_rest);
FRETWORK_BENT(bent_new_load);
FRETWORK_BENT(bent_little_load);
FRETWORK_BENT(bent_dragged_load);
FRETWORK_BENT(bent_repainted_tile);
BENCHMARK_CAPTURE(bent_moved_support, corotational, "corotational")->Apply(bent_sizes);
BENCHMARK(bent_factorization)
    ->Arg(100)
    ->Arg(500)
    ->Arg(2000)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK_CAPTURE(bent_pattern_derivatives, irregular, Lattice::Irregular)
    ->Arg(100)
    ->Arg(500)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(bent_pattern_derivatives, equal, Lattice::Equal)
    ->Arg(100)
    ->Arg(500)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace fretwork::simulation
