// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of an edit of a structure beside solving it from nothing. Hexagons of the paper's size, condensed
// onto six interface nodes each, form a lattice that is clamped at its left side and loaded at its right one.
// Each row ends with displacements under a load.
#include <fretwork/base/parallel.hpp>
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/linear_element.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/structure/factorized_structure.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace fretwork::mechanics {
namespace {

constexpr double kApothem = 0.0225;  // m
constexpr Material kPlastic{.young_modulus = 1e9, .poisson_ratio = 0.3};

std::array<Eigen::Vector3d, 6> ring(double radius, double degrees) {
    std::array<Eigen::Vector3d, 6> nodes;
    for (std::size_t i = 0; i < 6; ++i) {
        const double angle = (degrees + 60.0 * static_cast<double>(i)) * std::numbers::pi / 180.0;
        nodes[i] = {radius * std::cos(angle), radius * std::sin(angle), 0.0};
    }
    return nodes;
}

/// A pattern's hexagon of middling size: 48 beams of square bars; the interface nodes are the first six.
Frame hexagon(double bar) {
    Frame frame;
    for (const auto& nodes :
         {ring(kApothem, 270.0), ring(0.55 * kApothem, 278.0), ring(0.0173, 300.0), ring(0.0087, 300.0)})
        frame.nodes.insert(frame.nodes.end(), nodes.begin(), nodes.end());
    const auto beam = [&](int from, int to) {
        frame.beams.push_back({.nodes = {NodeIndex(from), NodeIndex(to)},
                               .section = rectangle_section(bar, bar),
                               .material = kPlastic});
    };
    for (int i = 0; i < 6; ++i) {
        const int next = (i + 1) % 6;
        beam(i, 6 + i);
        beam(6 + i, 12 + i);
        beam(i, 12 + i);
        beam(12 + i, next);
        beam(6 + i, 18 + i);
        beam(18 + i, 6 + next);
        beam(18 + i, 18 + next);
        beam(18 + i, 12 + i);
    }
    return frame;
}

Eigen::MatrixXd condensed(double bar) {
    std::vector<NodeIndex> tips;
    for (int i = 0; i < 6; ++i) tips.emplace_back(i);
    return condense(assemble(hexagon(bar)), tips);
}

/// The interface nodes of a lattice's tiles, and what holds and loads it.
struct Lattice {
    std::vector<std::vector<NodeIndex>> tiles;
    Assembly assembly;  ///< without elements
};

const Lattice& lattice_of(int tiles) {
    static std::map<int, Lattice> lattices;
    const auto [place, is_new] = lattices.try_emplace(tiles);
    Lattice& lattice = place->second;
    if (!is_new) return lattice;
    const int columns = static_cast<int>(std::lround(std::sqrt(tiles)));
    std::map<std::pair<long, long>, int> numbers;
    for (int t = 0; t < tiles; ++t) {
        const int row = t / columns;
        const int column = t % columns;
        const double x = kApothem * std::sqrt(3.0) * column;
        const double y = kApothem * (2.0 * row + column % 2);
        lattice.tiles.emplace_back();
        for (const Eigen::Vector3d& tip : ring(kApothem, 270.0)) {
            const Eigen::Vector3d node = tip + Eigen::Vector3d(x, y, 0.0);
            const auto key = std::pair(std::lround(node.x() * 1e6), std::lround(node.y() * 1e6));
            const auto [number, is_new_node] =
                numbers.try_emplace(key, static_cast<int>(lattice.assembly.nodes.size()));
            if (is_new_node) lattice.assembly.nodes.push_back(node);
            lattice.tiles.back().emplace_back(number->second);
        }
    }
    Assembly& assembly = lattice.assembly;
    assembly.reported_nodes = static_cast<int>(assembly.nodes.size());
    assembly.loads = NodeValues::Zero(assembly.reported_nodes, kDofsPerNode);
    const double right = kApothem * std::sqrt(3.0) * (columns - 1);
    for (int i = 0; i < assembly.reported_nodes; ++i) {
        const double x = assembly.nodes[i].x();
        if (x < 0.0) assembly.supports.push_back({NodeIndex(i), DofSet::all()});
        if (x > right) assembly.loads.row(i) << 1e-3, 0.0, 1e-3, 0.0, 0.0, 0.0;
    }
    return lattice;
}

/// The lattice of all different tiles, condensed one by one.
Assembly painted(const Lattice& lattice, int threads) {
    Assembly assembly = lattice.assembly;
    assembly.elements.resize(lattice.tiles.size());
    base::parallel_for(lattice.tiles.size(), threads, [&](std::size_t t) {
        const double bar = 0.002 * (1.0 + 0.3 * std::sin(static_cast<double>(t)));
        assembly.elements[t] = linear_element(lattice.tiles[t], {.stiffness = condensed(bar)});
    });
    return assembly;
}

struct Case {
    explicit Case(const benchmark::State& state)
        : lattice(lattice_of(static_cast<int>(state.range(0)))), threads(static_cast<int>(state.range(1))) {}
    const Lattice& lattice;
    int threads;
};

void report(benchmark::State& state, const Assembly& assembly) {
    state.counters["nodes"] = static_cast<double>(assembly.nodes.size());
}

void from_nothing(benchmark::State& state) {
    const Case c(state);
    for (auto _ : state)
        benchmark::DoNotOptimize(
            solve_linear(painted(c.lattice, c.threads), {.threads = c.threads}).displacements.data());
    report(state, c.lattice.assembly);
}

void from_condensed_tiles(benchmark::State& state) {
    const Case c(state);
    const Assembly assembly = painted(c.lattice, c.threads);
    for (auto _ : state)
        benchmark::DoNotOptimize(solve_linear(assembly, {.threads = c.threads}).displacements.data());
    report(state, assembly);
}

void new_load(benchmark::State& state) {
    const Case c(state);
    const Assembly assembly = painted(c.lattice, c.threads);
    const LinearSolver solver(assembly, {.threads = c.threads});
    NodeValues loads = assembly.loads;
    double residual = 0.0;
    for (auto _ : state) {
        loads(0, 2) += 1e-3;
        const Solution solution = solver.solve(loads);
        residual = solution.residual;
    }
    report(state, assembly);
    state.counters["residual"] = residual;
}

void new_material(benchmark::State& state) {
    const Case c(state);
    const Assembly assemblies[] = {painted(c.lattice, c.threads), painted(c.lattice, c.threads)};
    LinearSolver solver(assemblies[0], {.threads = c.threads});
    std::size_t turn = 0;
    for (auto _ : state) {
        solver.update(assemblies[++turn % 2]);
        benchmark::DoNotOptimize(solver.solve().displacements.data());
    }
    report(state, assemblies[0]);
}

void moved_support(benchmark::State& state) {
    const Case c(state);
    Assembly assembly = painted(c.lattice, c.threads);
    LinearSolver solver(assembly, {.threads = c.threads});
    const auto last = static_cast<int>(assembly.nodes.size()) - 1;
    int turn = 0;
    for (auto _ : state) {
        assembly.supports.back().node = NodeIndex(last - ++turn % 2);
        solver.update(assembly);
        benchmark::DoNotOptimize(solver.solve().displacements.data());
    }
    report(state, assembly);
}

/// Tiles in the middle of the lattice, repainted together; and a solution.
void repainted(benchmark::State& state, structure::ElementEdit edit) {
    const Case c(state);
    Assembly assembly = painted(c.lattice, c.threads);
    const structure::FactorizedStructure before(assembly, {.threads = c.threads});
    const auto tiles = static_cast<std::size_t>(state.range(2));
    const std::size_t first = c.lattice.tiles.size() / 2;
    for (std::size_t t = first; t < first + tiles; ++t)
        assembly.elements[t] = linear_element(c.lattice.tiles[t], {.stiffness = condensed(0.003)});
    std::size_t corrected = 0;
    for (auto _ : state) {
        const structure::FactorizedStructure after(before, assembly, edit);
        corrected = after.corrected_elements();
        benchmark::DoNotOptimize(after.systems().data());
    }
    report(state, assembly);
    state.counters["corrected"] = static_cast<double>(corrected);
}

/// One tile repainted as a session does it, with the solution.
void repainted_tile(benchmark::State& state) {
    const Case c(state);
    Assembly assembly = painted(c.lattice, c.threads);
    LinearSolver solver(assembly, {.threads = c.threads});
    const std::size_t tile = c.lattice.tiles.size() / 2;
    const std::shared_ptr<const Element> kinds[] = {
        linear_element(c.lattice.tiles[tile], {.stiffness = condensed(0.003)}),
        linear_element(c.lattice.tiles[tile], {.stiffness = condensed(0.0025)})};
    std::size_t turn = 0;
    double residual = 0.0;
    bool updated = false;
    for (auto _ : state) {
        assembly.elements[tile] = kinds[++turn % 2];
        updated = solver.update(assembly) == FactorChange::Updated;
        residual = solver.solve().residual;
    }
    report(state, assembly);
    state.counters["residual"] = residual;
    state.counters["updated"] = updated;
}

void of_all_sizes(benchmark::internal::Benchmark* rows) {
    rows->ArgNames({"tiles", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
    for (const int tiles : {100, 500, 2000, 10000}) rows->Args({tiles, 1})->Args({tiles, 2});
}

void of_more_repainted_tiles(benchmark::internal::Benchmark* rows) {
    rows->ArgNames({"tiles", "threads", "repainted"})->Unit(benchmark::kMillisecond)->UseRealTime();
    for (const int tiles : {100, 500, 2000, 10000}) {
        for (const int changed : {1, 2, 4, 8, 16}) rows->Args({tiles, 1, changed});
    }
}

BENCHMARK(from_nothing)->Apply(of_all_sizes);
BENCHMARK(from_condensed_tiles)->Apply(of_all_sizes);
BENCHMARK(new_load)->Apply(of_all_sizes);
BENCHMARK(repainted_tile)->Apply(of_all_sizes);
BENCHMARK(moved_support)->Apply(of_all_sizes);
BENCHMARK(new_material)->Apply(of_all_sizes);
BENCHMARK_CAPTURE(repainted, corrected, structure::ElementEdit::Correct)->Apply(of_more_repainted_tiles);
BENCHMARK_CAPTURE(repainted, cheaper, structure::ElementEdit::Cheaper)->Apply(of_more_repainted_tiles);
BENCHMARK_CAPTURE(repainted, refactored, structure::ElementEdit::Refactor)->Apply(of_more_repainted_tiles);

}  // namespace
}  // namespace fretwork::mechanics
