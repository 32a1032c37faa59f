// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/mechanics/nonlinear/nonlinear_system.hpp>
#include <fretwork/mechanics/sparse/dissection.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fretwork::mechanics::sparse {
namespace THIS_TEST {

using Eigen::VectorXd;

constexpr Components kAll = {true, true, true, true, true, true};

/// Squares in rows whose nodes are the middles of their sides, as tiles share them; each node is shifted a
/// little.
NodeGraph lattice(int rows, int columns, std::uint64_t seed) {
    sample::Random random(seed);
    const int upright = rows * (columns + 1);
    Cliques cliques;
    std::vector<Eigen::Vector3d> places;
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j <= columns; ++j) places.emplace_back(j, i + 0.5, 0.0);
    }
    for (int i = 0; i <= rows; ++i) {
        for (int j = 0; j < columns; ++j) places.emplace_back(j + 0.5, i, 0.0);
    }
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            const int left = i * (columns + 1) + j;
            const int lower = upright + i * columns + j;
            cliques.add(std::array{left, lower, left + 1, lower + columns});
        }
    }
    for (Eigen::Vector3d& place : places) place += 0.1 * Eigen::Vector3d(random.next(), random.next(), 0.0);
    NodeGraph graph = node_graph(static_cast<int>(places.size()), std::move(cliques));
    graph.places = std::move(places);
    return graph;
}

std::vector<bool> all_of(const NodeGraph& graph) {
    return std::vector<bool>(static_cast<std::size_t>(graph.nodes), true);
}

TEST(Dissection, OrderHoldsEachNodeThatTakesPartOnce) {
    for (const int rows : {1, 2, 7}) {
        const NodeGraph graph = lattice(rows, 9, 1);
        std::vector<bool> takes_part = all_of(graph);
        for (std::size_t i = 0; i < takes_part.size(); i += 5) takes_part[i] = false;
        std::vector<int> order = dissection_order(graph, takes_part);
        std::sort(order.begin(), order.end());
        std::vector<int> expected;
        for (int node = 0; node < graph.nodes; ++node) {
            if (takes_part[static_cast<std::size_t>(node)]) expected.push_back(node);
        }
        EXPECT_EQ(order, expected);
    }
}

TEST(Dissection, OrderDoesNotDependOnHowCliquesListTheirNodes) {
    const NodeGraph graph = lattice(9, 12, 2);
    Cliques turned;
    for (std::size_t clique = 0; clique < graph.cliques.size(); ++clique) {
        std::vector<int> nodes(graph.cliques[clique].begin(), graph.cliques[clique].end());
        std::rotate(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(clique % nodes.size()),
                    nodes.end());
        turned.add(nodes);
    }
    NodeGraph other = node_graph(graph.nodes, std::move(turned));
    other.places = graph.places;
    EXPECT_EQ(dissection_order(other, all_of(other)), dissection_order(graph, all_of(graph)));
}

TEST(Dissection, NodesOfNoCliqueAndAtOnePlaceHaveAnOrderToo) {
    NodeGraph graph = lattice(4, 4, 1);
    for (Eigen::Vector3d& place : graph.places) place.setZero();
    graph.places.emplace_back(1.0, 1.0, 1.0);
    graph.nodes += 1;
    EXPECT_EQ(dissection_order(graph, all_of(graph)).size(), static_cast<std::size_t>(graph.nodes));
}

// The last nodes are those that the first cut shares: without them the rest falls into two parts.
TEST(Dissection, LastNodesSeparateTheOthers) {
    const NodeGraph graph = lattice(10, 20, 3);
    const std::vector<int> order = dissection_order(graph, all_of(graph));
    std::vector<int> part(static_cast<std::size_t>(graph.nodes));
    std::iota(part.begin(), part.end(), 0);
    const std::size_t separator = 10;  // a cut between two columns shares one node a row
    const auto find = [&](int node) {
        while (part[static_cast<std::size_t>(node)] != node) node = part[static_cast<std::size_t>(node)];
        return node;
    };
    std::vector<bool> is_left(static_cast<std::size_t>(graph.nodes), true);
    for (std::size_t i = order.size() - separator; i < order.size(); ++i)
        is_left[static_cast<std::size_t>(order[i])] = false;
    for (int node = 0; node < graph.nodes; ++node) {
        for (int k = graph.start[static_cast<std::size_t>(node)];
             k < graph.start[static_cast<std::size_t>(node) + 1]; ++k) {
            const int other = graph.neighbour[static_cast<std::size_t>(k)];
            if (is_left[static_cast<std::size_t>(node)] && is_left[static_cast<std::size_t>(other)])
                part[static_cast<std::size_t>(find(node))] = find(other);
        }
    }
    int parts = 0;
    for (int node = 0; node < graph.nodes; ++node)
        parts += is_left[static_cast<std::size_t>(node)] && find(node) == node ? 1 : 0;
    EXPECT_EQ(parts, 2);
}

double work(const NodeGraph& graph, const std::vector<int>& order) {
    const std::vector<Components> free(static_cast<std::size_t>(graph.nodes), kAll);
    return Ldlt(SystemLayout(graph, free, order)).factorization_work();
}

// From nested dissection of a square with n cliques a side, work grows as n^3, and from an order row by row
// as n^4 [George1973].
TEST(Dissection, WorkGrowsWithTheThirdPowerOfTheSide) {
    const NodeGraph small = lattice(16, 16, 4);
    const NodeGraph large = lattice(32, 32, 4);
    const double ratio = work(large, dissection_order(large, all_of(large))) /
                         work(small, dissection_order(small, all_of(small)));
    EXPECT_LT(ratio, 10.5);
    std::vector<int> rows(static_cast<std::size_t>(large.nodes));
    std::iota(rows.begin(), rows.end(), 0);
    std::stable_sort(rows.begin(), rows.end(), [&](int a, int b) {
        return large.places[static_cast<std::size_t>(a)].y() < large.places[static_cast<std::size_t>(b)].y();
    });
    EXPECT_LT(2.0 * work(large, dissection_order(large, all_of(large))), work(large, rows));
}

TEST(Dissection, TheBetterOfTwoOrdersIsTaken) {
    const NodeGraph graph = lattice(40, 40, 5);
    NodeGraph without = graph;
    without.places.clear();
    const std::vector<Components> free(static_cast<std::size_t>(graph.nodes), kAll);
    EXPECT_LT(work(graph, elimination_order(graph, free)), work(without, elimination_order(without, free)));
    NodeGraph misplaced = graph;  // places that say nothing
    sample::Random random(7);
    for (Eigen::Vector3d& place : misplaced.places)
        place = Eigen::Vector3d(random.next(), random.next(), random.next());
    EXPECT_EQ(work(misplaced, elimination_order(misplaced, free)),
              work(without, elimination_order(without, free)));
}

/// A positive definite matrix of a lattice, and the same for Eigen.
struct System {
    explicit System(const NodeGraph& its_graph, double shift)
        : graph(its_graph),
          free(static_cast<std::size_t>(graph.nodes), kAll),
          layout(graph, free, elimination_order(graph, free)),
          values(layout.row().size(), 0.0) {
        sample::Random random(9);
        for (std::size_t clique = 0; clique < graph.cliques.size(); ++clique) {
            const auto size = static_cast<Eigen::Index>(graph.cliques[clique].size()) * kBlockSize;
            Eigen::MatrixXd half(size, size);
            for (double& entry : half.reshaped()) entry = random.next();
            Eigen::MatrixXd gram = half * half.transpose();
            gram.diagonal().array() += 1.0 - shift;
            layout.add(clique, gram, values);
        }
    }
    [[nodiscard]] Eigen::SparseMatrix<double> lower() const {
        const int n = layout.equations();
        return Eigen::Map<const Eigen::SparseMatrix<double>>(n, n, static_cast<int>(values.size()),
                                                             layout.column_start().data(),
                                                             layout.row().data(), values.data());
    }
    NodeGraph graph;
    std::vector<Components> free;
    SystemLayout layout;
    std::vector<double> values;
};

// Eigen's factorization has an order, a structure and sums of its own.
TEST(Dissection, FactorsAgreeWithEigens) {
    for (const auto& [rows, columns] : {std::pair(5, 60), std::pair(21, 17)}) {
        for (const double shift : {0.0, 12.0}) {  // positive definite, and not
            const System system(lattice(rows, columns, 6), shift);
            const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> expected(system.lower());
            ASSERT_EQ(expected.info(), Eigen::Success);
            Ldlt factors(system.layout);
            const Ldlt::Outcome outcome = factors.factorize(system.values);
            ASSERT_EQ(outcome.zero_pivot, -1);
            EXPECT_EQ(outcome.negative_pivots, (expected.vectorD().array() < 0.0).count()) << shift;
            EXPECT_EQ(outcome.positive_definite(), shift == 0.0);
            sample::Random random(2);
            VectorXd load(system.layout.equations());
            for (double& entry : load) entry = random.next();
            VectorXd found = load;
            factors.solve(found);
            const VectorXd solution = expected.solve(load);
            EXPECT_LT((found - solution).norm(), 1e-9 * solution.norm()) << shift;
        }
    }
}

TEST(Dissection, ThreadsChangeNoBitOfItsFactors) {
    const System system(lattice(40, 40, 8), 0.0);
    Ldlt one(system.layout, 1);
    one.factorize(system.values);
    VectorXd load = VectorXd::LinSpaced(system.layout.equations(), -1.0, 1.0);
    VectorXd expected = load;
    one.solve(expected);
    ASSERT_GT(plan_elimination(supernode_tree(system.layout), 2).parent.size(), 4U);
    for (const int threads : {2, 3, 5}) {
        Ldlt many(system.layout, threads);
        many.factorize(system.values);
        VectorXd found = load;
        many.solve(found);
        EXPECT_TRUE(found == expected) << threads;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics::sparse
