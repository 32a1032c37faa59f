// SPDX-License-Identifier: GPL-3.0-or-later
// One thread, but for the rows that end in the number of theirs. The honeycombs are flat, clamped on their
// left side and loaded on their right one; the sizes are those at which other programs have been measured
// (508, 2,044, 9,938 and 49,926 nodes, as near as whole rows come). The rows `stiffness` take one matrix, six
// unknowns a node, from its pattern to a solution: by this project's solver, and by others as a yardstick.
// For one thread of theirs, set OPENBLAS_NUM_THREADS=1 and OMP_NUM_THREADS=1.
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/corotational_element.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/nonlinear/nonlinear_system.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>
#include <fretwork/mechanics/structure/condensing.hpp>

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCholesky>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <span>

namespace fretwork::mechanics {
namespace {

constexpr double kSide = 0.01;  // m
const Section kBar = rectangle_section(0.002, 0.002);
constexpr Material kPlastic{.young_modulus = 1e9, .poisson_ratio = 0.3};

/// Merges nodes that lie at the same place, and beams that join the same nodes.
class FrameBuilder {
  public:
    int node(double x, double y) {
        const auto key = std::pair(std::lround(x / kSide * 1e4), std::lround(y / kSide * 1e4));
        const auto [place, is_new] = numbers_.try_emplace(key, static_cast<int>(frame_.nodes.size()));
        if (is_new) frame_.nodes.emplace_back(x, y, 0.0);
        return place->second;
    }
    void beam(int from, int to) {
        if (!joined_.insert(std::minmax(from, to)).second) return;
        frame_.beams.push_back(
            {.nodes = {NodeIndex(from), NodeIndex(to)}, .section = kBar, .material = kPlastic});
    }
    Frame take() { return std::move(frame_); }

  private:
    Frame frame_;
    std::map<std::pair<long, long>, int> numbers_;
    std::set<std::pair<int, int>> joined_;
};

Frame honeycomb(int columns, int rows) {
    FrameBuilder builder;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const double x = kSide * std::sqrt(3.0) * (i + 0.5 * (j % 2));
            const double y = kSide * 1.5 * j;
            int corner[6];
            for (int k = 0; k < 6; ++k) {
                const double angle = std::numbers::pi * (1.0 + 2.0 * k) / 6.0;
                corner[k] = builder.node(x + kSide * std::cos(angle), y + kSide * std::sin(angle));
            }
            for (int k = 0; k < 6; ++k) builder.beam(corner[k], corner[(k + 1) % 6]);
        }
    }
    return builder.take();
}

/// Held at its left side, pulled and pushed out of its plane at its right one.
Frame held_honeycomb(int columns, int rows) {
    Frame frame = honeycomb(columns, rows);
    const auto by_x = [](const auto& a, const auto& b) { return a.x() < b.x(); };
    const double left = std::min_element(frame.nodes.begin(), frame.nodes.end(), by_x)->x();
    const double right = std::max_element(frame.nodes.begin(), frame.nodes.end(), by_x)->x();
    for (std::size_t i = 0; i < frame.nodes.size(); ++i) {
        if (frame.nodes[i].x() < left + 0.1 * kSide) frame.supports.push_back({NodeIndex(i), DofSet::all()});
        if (frame.nodes[i].x() > right - 0.1 * kSide)
            frame.loads.push_back({NodeIndex(i), Eigen::Vector3d(2e-4, 0.0, 2e-4)});
    }
    return frame;
}

/// A pattern's hexagon of middling size: 48 beams; the interface nodes are the first six.
Frame hexagon() {
    FrameBuilder builder;
    const double apothem = 0.0225;
    const auto ring = [&](double radius, double degrees) {
        std::array<int, 6> nodes{};
        for (int i = 0; i < 6; ++i) {
            const double angle = (degrees + 60.0 * i) * std::numbers::pi / 180.0;
            nodes[i] = builder.node(radius * std::cos(angle), radius * std::sin(angle));
        }
        return nodes;
    };
    const auto tips = ring(apothem, 270.0);
    const auto middle = ring(0.55 * apothem, 278.0);
    const auto outer = ring(0.0173, 300.0);
    const auto inner = ring(0.0087, 300.0);
    for (std::size_t i = 0; i < 6; ++i) {
        const std::size_t next = (i + 1) % 6;
        builder.beam(tips[i], middle[i]);
        builder.beam(middle[i], outer[i]);
        builder.beam(tips[i], outer[i]);
        builder.beam(outer[i], tips[next]);
        builder.beam(middle[i], inner[i]);
        builder.beam(inner[i], middle[next]);
        builder.beam(inner[i], inner[next]);
        builder.beam(inner[i], outer[i]);
    }
    return builder.take();
}

Frame bent_hexagon() {
    Frame frame = hexagon();
    for (const int node : {0, 1, 2}) frame.supports.push_back({NodeIndex(node), DofSet::all()});
    for (const int node : {3, 4, 5}) frame.loads.push_back({NodeIndex(node), {0.0, 0.0, 2.0}});
    return frame;
}

Frame domed_hexagon() {
    Frame frame = hexagon();
    frame.supports = {{NodeIndex(0), {{true, true, true, false, true, false}}},
                      {NodeIndex(3), {{true, false, true, false, true, false}}}};
    frame.loads.push_back({NodeIndex(3), {0.0, -3.0, 0.0}});
    for (const int node : {1, 2, 4, 5}) {
        const double angle = (270.0 + 60.0 * node) * std::numbers::pi / 180.0;
        frame.loads.push_back({NodeIndex(node),
                               Eigen::Vector3d::Zero(),
                               {-0.03 * std::sin(angle), 0.03 * std::cos(angle), 0.0}});
    }
    return frame;
}

void report_size(benchmark::State& state, const Frame& frame) {
    state.counters["nodes"] = static_cast<double>(frame.nodes.size());
    state.counters["beams"] = static_cast<double>(frame.beams.size());
}

void linear_from_frame_to_displacements(benchmark::State& state) {
    const Frame frame = held_honeycomb(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const LinearOptions options{.threads = static_cast<int>(state.range(2))};
    for (auto _ : state)
        benchmark::DoNotOptimize(solve_linear(assemble(frame), options).displacements.data());
    report_size(state, frame);
}

void linear_another_load(benchmark::State& state) {
    const Frame frame = held_honeycomb(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const Assembly assembly = assemble(frame);
    LinearSolver solver(assembly, {.threads = static_cast<int>(state.range(2))});
    for (auto _ : state) benchmark::DoNotOptimize(solver.solve(assembly.loads).displacements.data());
    report_size(state, frame);
}

void linear_other_sections(benchmark::State& state) {
    const Frame frame = held_honeycomb(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const Assembly assemblies[] = {assemble(frame), assemble(frame)};
    LinearSolver solver(assemblies[0], {.threads = static_cast<int>(state.range(2))});
    std::size_t turn = 0;
    for (auto _ : state) solver.update(assemblies[++turn % 2]);
    report_size(state, frame);
}

/// The stiffness at rest and the load of a honeycomb, neither split into bending and membrane.
class StiffnessProblem {
  public:
    explicit StiffnessProblem(const Frame& frame) : assembly_(assemble(frame)), system_(assembly_) {
        system_.evaluate(system_.unknowns().rest(), 0.0);
        load_ = system_.load_rate();
    }
    [[nodiscard]] const sparse::SystemLayout& layout() const { return system_.unknowns().layout(); }
    [[nodiscard]] std::span<const double> values() const { return system_.tangent(); }
    [[nodiscard]] const Eigen::VectorXd& load() const { return load_; }
    /// The lower triangle, its rows in a random order: no program inherits the order of another.
    [[nodiscard]] Eigen::SparseMatrix<double> shuffled() const {
        const int n = system_.unknowns().equations();
        const Eigen::Map<const Eigen::SparseMatrix<double>> lower(n, n, static_cast<int>(values().size()),
                                                                  layout().column_start().data(),
                                                                  layout().row().data(), values().data());
        Eigen::PermutationMatrix<Eigen::Dynamic> order(n);
        order.setIdentity();
        std::shuffle(order.indices().begin(), order.indices().end(), std::mt19937(1));
        Eigen::SparseMatrix<double> result(n, n);
        result.selfadjointView<Eigen::Lower>() = lower.selfadjointView<Eigen::Lower>().twistedBy(order);
        return result;
    }

  private:
    Assembly assembly_;
    nonlinear::NonlinearSystem system_;
    Eigen::VectorXd load_;
};

void stiffness_by_this_project(benchmark::State& state) {
    const Frame frame = held_honeycomb(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const Assembly assembly = assemble(frame);
    const StiffnessProblem problem(frame);
    for (auto _ : state) {
        const nonlinear::NonlinearSystem ordered(assembly);
        sparse::Ldlt factors(ordered.unknowns().layout());
        Eigen::VectorXd x = problem.load();
        if (!factors.factorize(problem.values()).positive_definite()) state.SkipWithError("singular");
        factors.solve(x);
        benchmark::DoNotOptimize(x.data());
    }
    report_size(state, frame);
}

template <class Solver>
void stiffness_by(benchmark::State& state) {
    const Frame frame = held_honeycomb(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const StiffnessProblem problem(frame);
    const Eigen::SparseMatrix<double> matrix = problem.shuffled();
    for (auto _ : state) {
        const Solver factors(matrix);
        if (factors.info() != Eigen::Success) state.SkipWithError("singular");
        benchmark::DoNotOptimize(factors.solve(problem.load()).eval().data());
    }
    report_size(state, frame);
}
using EigenLdlt = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;
using CholmodSupernodal = Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>>;

/// The graph of a lattice of hexagonal tiles, of which each couples the middles of its six sides.
sparse::NodeGraph tile_graph(int columns, int rows) {
    FrameBuilder middles;
    sparse::Cliques tiles;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            std::array<int, 6> tile{};
            for (int k = 0; k < 6; ++k) {
                const double angle = std::numbers::pi * k / 3.0;
                tile[k] = middles.node(kSide * std::sqrt(3.0) * (i + 0.5 * (j % 2) + 0.5 * std::cos(angle)),
                                       kSide * (1.5 * j + 0.5 * std::sqrt(3.0) * std::sin(angle)));
            }
            tiles.add(tile);
        }
    }
    const Frame frame = middles.take();
    sparse::NodeGraph graph = sparse::node_graph(static_cast<int>(frame.nodes.size()), std::move(tiles));
    graph.places.assign(frame.nodes.begin(), frame.nodes.end());
    return graph;
}

/// What an order costs, and what a factorization in it: with the places of the nodes, and without.
enum class Places { Known, Unknown };
void order_tiles(benchmark::State& state, Places places) {
    sparse::NodeGraph graph = tile_graph(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    if (places == Places::Unknown) graph.places.clear();
    const std::vector<sparse::Components> free(graph.nodes, {true, true, true, true, true, true});
    std::vector<int> order;
    for (auto _ : state) {
        order = sparse::elimination_order(graph, free);
        benchmark::DoNotOptimize(order.data());
    }
    const sparse::SystemLayout layout(graph, free, order);
    state.counters["nodes"] = graph.nodes;
    state.counters["multiplications"] = sparse::Ldlt(layout).factorization_work();
}

int iterations_of(const std::vector<Solution>& path) {
    int iterations = 0;
    for (const Solution& solution : path) iterations += solution.iterations;
    return iterations;
}

void hexagon_path(benchmark::State& state, Frame (*make)()) {
    const Frame frame = make();
    std::vector<double> factors;
    for (int k = 1; k <= 10; ++k) factors.push_back(k / 10.0);
    int iterations = 0;
    for (auto _ : state) {
        const auto path = follow_load_path(assemble(frame), factors);
        if (!path.back().converged()) state.SkipWithError("not converged");
        iterations = iterations_of(path);
    }
    report_size(state, frame);
    state.counters["solves"] = iterations;
}

std::vector<NodeIndex> first_nodes(int count) {
    std::vector<NodeIndex> nodes;
    for (int i = 0; i < count; ++i) nodes.emplace_back(i);
    return nodes;
}

void condense_hexagon(benchmark::State& state) {
    const Frame frame = hexagon();
    const auto tips = first_nodes(6);
    for (auto _ : state) benchmark::DoNotOptimize(condense(assemble(frame), tips).data());
    report_size(state, frame);
}

/// A tile's frame as elements: what condense_hexagon does before it condenses.
void assemble_hexagon(benchmark::State& state) {
    const Frame frame = hexagon();
    for (auto _ : state) benchmark::DoNotOptimize(assemble(frame).elements.data());
    report_size(state, frame);
}

using Elimination = Eigen::MatrixXd (*)(const structure::CondensingTask&);

/// With more divisions, more nodes to eliminate.
void condense_by(benchmark::State& state, Elimination elimination) {
    Frame frame = hexagon();
    for (Beam& beam : frame.beams) beam.divisions = static_cast<int>(state.range(0));
    const Assembly assembly = assemble(frame);
    const auto tips = first_nodes(6);
    for (auto _ : state)
        benchmark::DoNotOptimize(elimination(structure::condensing_task(assembly, tips)).data());
    state.counters["nodes"] = static_cast<double>(assembly.nodes.size());
}

/// The hexagon as one corotational element, its nodes moved by a tenth of their distance and turned by 0.2
/// rad.
struct CondensedHexagon {
    std::unique_ptr<const Element> element;
    std::vector<NodeState> states{6};

    CondensedHexagon() {
        const Frame frame = hexagon();
        const CorotationalBody::Parts parts{{frame.nodes.begin(), frame.nodes.begin() + 6},
                                            condense(assemble(frame), first_nodes(6))};
        element = corotational_element(first_nodes(6), std::make_shared<CorotationalBody>(parts),
                                       Eigen::Matrix3d::Identity());
        std::mt19937 random(1);
        std::uniform_real_distribution<double> share(-0.1, 0.1);
        for (std::size_t i = 0; i < states.size(); ++i) {
            const Eigen::Vector3d turn(share(random), share(random), share(random));
            states[i].displacement = share(random) * frame.nodes[i];
            states[i].rotation = Eigen::AngleAxisd(2.0 * turn.norm(), turn.normalized());
        }
    }
};

void corotational_hexagon(benchmark::State& state, Demand demand) {
    const CondensedHexagon tile;
    const auto size = static_cast<std::size_t>(tile.element->stress_count());
    const std::vector<double> given(size, 0.0);
    std::vector<double> own(size);
    std::vector<double> slopes(size * size);
    MixedResponse response;
    for (auto _ : state) {
        tile.element->evaluate_mixed(tile.states, demand, {given, own, slopes}, response);
        benchmark::DoNotOptimize(response.force.data());
    }
}

/// As many beams as 500 tiles of forty, to a deflection of a third of the length.
void nonlinear_surface(benchmark::State& state) {
    const Frame frame = held_honeycomb(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const double factors[] = {0.5, 1.0};
    double deflection = 0.0;
    int iterations = 0;
    for (auto _ : state) {
        const auto path =
            follow_load_path(assemble(frame), factors, {.threads = static_cast<int>(state.range(2))});
        if (!path.back().converged()) state.SkipWithError("not converged");
        iterations = iterations_of(path);
        deflection = path.back().displacements.leftCols<3>().rowwise().norm().maxCoeff();
    }
    report_size(state, frame);
    state.counters["deflection_m"] = deflection;
    state.counters["solves"] = iterations;
}

void of_all_sizes(benchmark::internal::Benchmark* rows) {
    rows->ArgNames({"columns", "rows", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
    rows->Args({15, 15, 1})->Args({31, 31, 1})->Args({69, 70, 1})->Args({155, 160, 1});
    rows->Args({69, 70, 2})->Args({155, 160, 2});
}

void of_ten_thousand_nodes(benchmark::internal::Benchmark* rows) {
    rows->ArgNames({"columns", "rows", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
    rows->Args({69, 70, 1})->Args({69, 70, 2});
}

void of_three_sizes(benchmark::internal::Benchmark* rows) {
    rows->ArgNames({"columns", "rows"})->Unit(benchmark::kMillisecond)->UseRealTime();
    rows->Args({15, 15})->Args({31, 31})->Args({69, 70});
}

void of_tiles(benchmark::internal::Benchmark* rows) {
    rows->ArgNames({"columns", "rows"})->Unit(benchmark::kMillisecond);
    rows->Args({10, 10})->Args({22, 23})->Args({45, 45})->Args({100, 100});
}

void of_more_inner_nodes(benchmark::internal::Benchmark* rows) {
    rows->ArgName("divisions")->Unit(benchmark::kMicrosecond)->DenseRange(1, 3);
}

void of_twenty_thousand_beams(benchmark::internal::Benchmark* rows) {
    rows->ArgNames({"columns", "rows", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
    rows->Args({80, 83, 1})->Args({80, 83, 2});
}

BENCHMARK(linear_from_frame_to_displacements)->Apply(of_all_sizes);
BENCHMARK(linear_another_load)->Apply(of_ten_thousand_nodes);
BENCHMARK(linear_other_sections)->Apply(of_ten_thousand_nodes);
BENCHMARK(stiffness_by_this_project)->Apply(of_three_sizes);
BENCHMARK(stiffness_by<EigenLdlt>)->Apply(of_three_sizes);
BENCHMARK(stiffness_by<CholmodSupernodal>)->Apply(of_three_sizes);
BENCHMARK_CAPTURE(order_tiles, by_place, Places::Known)->Apply(of_tiles);
BENCHMARK_CAPTURE(order_tiles, by_degree, Places::Unknown)->Apply(of_tiles);
BENCHMARK_CAPTURE(hexagon_path, bending, bent_hexagon)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(hexagon_path, dome, domed_hexagon)->Unit(benchmark::kMillisecond);
BENCHMARK(condense_hexagon)->Unit(benchmark::kMicrosecond);
BENCHMARK(assemble_hexagon)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(condense_by, dense, structure::condense_dense)->Apply(of_more_inner_nodes);
BENCHMARK_CAPTURE(condense_by, sparse, structure::condense_sparse)->Apply(of_more_inner_nodes);
BENCHMARK_CAPTURE(corotational_hexagon, force, Demand::Force)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(corotational_hexagon, tangent, Demand::Tangent)->Unit(benchmark::kMicrosecond);
BENCHMARK(nonlinear_surface)->Apply(of_twenty_thousand_beams);

}  // namespace
}  // namespace fretwork::mechanics
