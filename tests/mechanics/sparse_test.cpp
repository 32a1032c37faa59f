// SPDX-License-Identifier: GPL-3.0-or-later
// The sparse solver alone, on graphs that are no structures.
#include "sample.hpp"

#include <fretwork/mechanics/sparse/ldlt.hpp>
#include <fretwork/mechanics/sparse/node_graph.hpp>
#include <fretwork/mechanics/sparse/system_layout.hpp>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace fretwork::mechanics::sparse {
namespace THIS_TEST {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Components kFirstOnly = {true, false, false, false, false, false};
constexpr Components kEveryOther = {true, false, true, false, true, false};
constexpr Components kAll = {true, true, true, true, true, true};

/// A symmetric positive definite matrix from random cliques of two to five nodes, sparse and dense. Each
/// clique adds a random Gram matrix, and every node with unknowns the unit matrix.
class RandomSystem {
  public:
    RandomSystem(int nodes, std::uint64_t seed, const std::vector<Components>& kinds) : random_(seed) {
        free_.resize(static_cast<std::size_t>(nodes));
        for (Components& free : free_) free = kinds[below(kinds.size())];
        Cliques cliques;
        for (int i = 0; i < 2 * nodes; ++i) cliques.add(random_clique());
        graph_ = node_graph(nodes, std::move(cliques));
        order_ = elimination_order(graph_, free_);
        layout_ = std::make_unique<SystemLayout>(graph_, free_, order_);
        values_.assign(layout_->row().size(), 0.0);
        dense_ = MatrixXd::Zero(layout_->equations(), layout_->equations());
        for (std::size_t i = 0; i < graph_.cliques.size(); ++i) add_clique(i);
        for (const int node : order_) add_node(node);
    }
    [[nodiscard]] const NodeGraph& graph() const { return graph_; }
    [[nodiscard]] const std::vector<int>& order() const { return order_; }
    [[nodiscard]] const std::vector<Components>& free() const { return free_; }
    [[nodiscard]] const SystemLayout& layout() const { return *layout_; }
    [[nodiscard]] const std::vector<double>& values() const { return values_; }
    [[nodiscard]] const MatrixXd& dense() const { return dense_; }
    VectorXd random_vector() {
        VectorXd v(dense_.rows());
        for (double& entry : v) entry = random_.next();
        return v;
    }

  private:
    std::size_t below(std::size_t count) {
        return static_cast<std::size_t>(0.5 * (random_.next() + 1.0) * static_cast<double>(count));
    }

    std::vector<int> random_clique() {
        std::set<int> nodes;
        const std::size_t size = 2 + below(4);
        while (nodes.size() < size) nodes.insert(static_cast<int>(below(free_.size())));
        std::vector<int> list(nodes.begin(), nodes.end());
        std::rotate(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(below(size)), list.end());
        return list;
    }

    void add_clique(std::size_t clique) {
        const auto nodes = graph_.cliques[clique];
        const auto size = static_cast<Eigen::Index>(nodes.size()) * kBlockSize;
        MatrixXd half(size, size);
        for (double& entry : half.reshaped()) entry = random_.next();
        const MatrixXd matrix = half * half.transpose();
        layout_->add(clique, matrix, values_);
        for (Eigen::Index i = 0; i < size; ++i) {
            for (Eigen::Index j = 0; j < size; ++j) {
                const int row = equation(nodes, i);
                const int column = equation(nodes, j);
                if (row >= 0 && column >= 0) dense_(row, column) += matrix(i, j);
            }
        }
    }

    [[nodiscard]] int equation(std::span<const int> nodes, Eigen::Index place) const {
        return layout_->equation(nodes[place / kBlockSize], static_cast<int>(place % kBlockSize));
    }

    void add_node(int node) {
        layout_->add_node(node, MatrixXd::Identity(kBlockSize, kBlockSize), values_);
        for (int d = 0; d < kBlockSize; ++d) {
            const int i = layout_->equation(node, d);
            if (i >= 0) dense_(i, i) += 1.0;
        }
    }

    sample::Random random_;
    std::vector<Components> free_;
    NodeGraph graph_;
    std::vector<int> order_;
    std::unique_ptr<SystemLayout> layout_;
    std::vector<double> values_;
    MatrixXd dense_;
};

std::vector<RandomSystem> random_systems() {
    std::vector<RandomSystem> systems;
    for (const int nodes : {6, 25, 90}) {
        systems.emplace_back(nodes, 11, std::vector{kFirstOnly});
        systems.emplace_back(nodes, 12, std::vector{kAll});
        systems.emplace_back(nodes, 13, std::vector{kAll, kFirstOnly, kEveryOther, Components{}});
    }
    return systems;
}

TEST(Sparse, OrderHoldsEachNodeWithUnknownsOnce) {
    for (const RandomSystem& system : random_systems()) {
        std::vector<int> sorted = system.order();
        std::sort(sorted.begin(), sorted.end());
        std::vector<int> expected;
        for (std::size_t i = 0; i < system.free().size(); ++i) {
            if (system.free()[i] != Components{}) expected.push_back(static_cast<int>(i));
        }
        EXPECT_EQ(sorted, expected);
    }
}

TEST(Sparse, ProductIsThatOfTheDenseMatrix) {
    for (RandomSystem& system : random_systems()) {
        const VectorXd x = system.random_vector();
        VectorXd y = VectorXd::Zero(x.size());
        add_product(system.layout(), system.values(), x, y);
        EXPECT_LT((y - system.dense() * x).norm(), 1e-13 * system.dense().norm() * x.norm());
    }
}

TEST(Sparse, SolvesAsADenseFactorizationDoes) {
    for (RandomSystem& system : random_systems()) {
        const VectorXd right_side = system.random_vector();
        Ldlt factors(system.layout());
        ASSERT_TRUE(factors.factorize(system.values()).positive_definite());
        VectorXd found = right_side;
        factors.solve(found);
        const VectorXd expected = system.dense().ldlt().solve(right_side);
        // The least eigenvalue is one or more, so the condition is below the matrix' norm.
        EXPECT_LT((found - expected).norm(), 1e-14 * system.dense().norm() * expected.norm());
    }
}

// The Laplacian of a connected graph with one node held is positive definite, and its rows that meet the held
// node are the only ones whose sum is not zero: a unit value there is a unit value everywhere.
TEST(Sparse, LaplacianSpreadsTheValueOfTheHeldNode) {
    constexpr int kNodes = 200;
    sample::Random random(5);
    Cliques cliques;
    for (int i = 1; i < kNodes; ++i)
        cliques.add(std::array{i, static_cast<int>(0.5 * (random.next() + 1.0) * i)});
    std::vector<Components> free(kNodes, kFirstOnly);
    free[0] = {};
    const NodeGraph graph = node_graph(kNodes, cliques);
    const SystemLayout layout(graph, free, elimination_order(graph, free));
    ASSERT_EQ(layout.equations(), kNodes - 1);
    std::vector<double> values(layout.row().size(), 0.0);
    VectorXd right_side = VectorXd::Zero(layout.equations());
    MatrixXd edge = MatrixXd::Zero(2 * kBlockSize, 2 * kBlockSize);
    for (std::size_t i = 0; i < graph.cliques.size(); ++i) {
        const double weight = random.next() + 1.5;
        edge(0, 0) = edge(kBlockSize, kBlockSize) = weight;
        edge(0, kBlockSize) = edge(kBlockSize, 0) = -weight;
        layout.add(i, edge, values);
        if (graph.cliques[i][1] == 0) right_side[layout.equation(graph.cliques[i][0], 0)] += weight;
    }
    Ldlt factors(layout);
    ASSERT_TRUE(factors.factorize(values).positive_definite());
    factors.solve(right_side);
    EXPECT_LT((right_side - VectorXd::Ones(kNodes - 1)).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics::sparse
