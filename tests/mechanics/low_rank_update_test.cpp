// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/mechanics/sparse/low_rank_update.hpp>

#include <gtest/gtest.h>

namespace fretwork::mechanics::sparse {
namespace THIS_TEST {

/// A chain of coupled nodes, six unknowns each.
class Chain {
  public:
    explicit Chain(int nodes) : layout_(layout_of(nodes)), values_(layout_.row().size(), 0.0) {
        mechanics::sample::Random random(1);
        for (std::size_t clique = 0; clique + 1 < static_cast<std::size_t>(nodes); ++clique) {
            Eigen::MatrixXd root(12, 12);
            for (double& value : root.reshaped()) value = random.next();
            layout_.add(clique, root * root.transpose() + Eigen::MatrixXd::Identity(12, 12), values_);
        }
    }
    [[nodiscard]] const SystemLayout& layout() const { return layout_; }
    [[nodiscard]] Ldlt factors() const {
        Ldlt factors(layout_);
        EXPECT_TRUE(factors.factorize(values_).positive_definite());
        return factors;
    }
    [[nodiscard]] Eigen::MatrixXd dense() const {
        Eigen::MatrixXd matrix(layout_.equations(), layout_.equations());
        for (Eigen::Index i = 0; i < matrix.cols(); ++i) {
            Eigen::VectorXd column = Eigen::VectorXd::Zero(matrix.rows());
            add_product(layout_, values_, Eigen::VectorXd::Unit(matrix.rows(), i), column);
            matrix.col(i) = column;
        }
        return matrix;
    }

  private:
    static SystemLayout layout_of(int nodes) {
        Cliques cliques;
        for (int i = 0; i + 1 < nodes; ++i) cliques.add(std::vector<int>{i, i + 1});
        const NodeGraph graph = node_graph(nodes, std::move(cliques));
        Components all;
        all.fill(true);
        const std::vector<Components> free(static_cast<std::size_t>(nodes), all);
        return {graph, free, elimination_order(graph, free)};
    }
    SystemLayout layout_;
    std::vector<double> values_;
};

/// Two changes that overlap in equation 7: one stiffer, one a little softer.
std::vector<MatrixChange> changes() {
    const Eigen::Vector3d a(1.0, -2.0, 0.5), b(0.3, 0.2, -0.1);
    return {{{3, 7, 40}, a * a.transpose()}, {{7, 8, 20}, -b * b.transpose()}};
}

Eigen::MatrixXd changed(Eigen::MatrixXd matrix) {
    for (const MatrixChange& change : changes()) matrix(change.equations, change.equations) += change.values;
    return matrix;
}

TEST(LowRankUpdate, SolvesTheChangedMatrix) {
    const Chain chain(12);
    const Ldlt factors = chain.factors();
    const auto update = LowRankUpdate::make(factors, changes());
    ASSERT_TRUE(update);
    const Eigen::MatrixXd matrix = changed(chain.dense());
    const Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(matrix.rows(), -1.0, 2.0);
    Eigen::VectorXd found = matrix * expected;
    update->solve(factors, found);
    EXPECT_LT((found - expected).norm(), 1e-12 * expected.norm());
}

TEST(LowRankUpdate, ProductIsThatOfTheChanges) {
    const Chain chain(12);
    const auto update = LowRankUpdate::make(chain.factors(), changes());
    ASSERT_TRUE(update);
    const Eigen::MatrixXd matrix = chain.dense();
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(matrix.rows(), -1.0, 2.0);
    Eigen::VectorXd found = matrix * x;
    update->add_product(x, found);
    EXPECT_LT((found - changed(matrix) * x).norm(), 1e-13 * found.norm());
}

TEST(LowRankUpdate, RefusesWhatMakesTheMatrixIndefiniteOrNearlySingular) {
    const Chain chain(12);
    const Ldlt factors = chain.factors();
    const double share = 1.0 / chain.dense().inverse()(5, 5);  // what equation 5 can lose
    const auto less = [&](double part) {
        return LowRankUpdate::make(factors, {{{5}, Eigen::MatrixXd::Constant(1, 1, -part * share)}});
    };
    EXPECT_TRUE(less(0.99));
    EXPECT_FALSE(less(1.0 - 1e-7));
    EXPECT_FALSE(less(1.01));
}

TEST(Ldlt, InverseFormIsThatOfTheDenseInverse) {
    const Chain chain(12);
    const std::vector<int> equations = {2, 30, 31};
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(chain.layout().equations(), 2);
    columns(2, 0) = 1.0;
    columns(30, 0) = -2.0;
    columns(31, 1) = 3.0;
    const Eigen::MatrixXd expected = columns.transpose() * chain.dense().inverse() * columns;
    EXPECT_LT((chain.factors().inverse_form(columns, equations) - expected).norm(), 1e-12 * expected.norm());
}

/// Neighbouring nodes are coupled; the order of a clique's equations is the caller's.
TEST(Ldlt, InverseBlocksAreThoseOfTheDenseInverse) {
    const Chain chain(40);
    const Eigen::MatrixXd inverse = chain.dense().inverse();
    std::vector<std::vector<int>> cliques = {{}};
    for (int node = 0; node + 1 < 40; ++node) {
        auto& clique = cliques.emplace_back();
        for (const int coupled : {node + 1, node}) {
            for (int d = 0; d < 6; ++d) {
                if (chain.layout().equation(coupled, d) >= 0)
                    clique.push_back(chain.layout().equation(coupled, d));
            }
        }
    }
    const auto blocks = chain.factors().inverse_blocks(cliques);
    for (std::size_t c = 0; c < cliques.size(); ++c) {
        const Eigen::MatrixXd expected = inverse(cliques[c], cliques[c]);
        EXPECT_LE((blocks[c] - expected).norm(), 1e-11 * expected.norm()) << c;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics::sparse
