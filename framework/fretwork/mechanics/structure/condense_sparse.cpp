// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/sparse/ldlt.hpp>
#include <fretwork/mechanics/structure/condensing.hpp>
#include <fretwork/mechanics/structure/coupling.hpp>

namespace fretwork::mechanics::structure {
namespace {

class SparseCondensation {
  public:
    explicit SparseCondensation(const CondensingTask& task) : task_(task) {}

    Eigen::MatrixXd run() {
        const std::vector<sparse::Components> free = components(task_.inner);
        const sparse::NodeGraph graph = coupling_graph(task_.assembly);
        const sparse::SystemLayout layout(graph, free, sparse::elimination_order(graph, free));
        assemble(layout);
        if (layout.equations() > 0) eliminate(layout);
        return std::move(kept_stiffness_);
    }

  private:
    void assemble(const sparse::SystemLayout& layout) {
        const Eigen::Index size = static_cast<Eigen::Index>(task_.kept_nodes) * kDofsPerNode;
        kept_stiffness_.setZero(size, size);
        coupling_.setZero(layout.equations(), size);
        values_.assign(layout.row().size(), 0.0);
        Eigen::MatrixXd stiffness;
        for (std::size_t e = 0; e < task_.assembly.elements.size(); ++e) {
            const auto nodes = task_.assembly.elements[e]->nodes();
            task_.assembly.elements[e]->rest_stiffness(stiffness);
            layout.add(e, stiffness, values_);
            for (std::size_t i = 0; i < nodes.size(); ++i) {
                const int slot = task_.slot[nodes[i]];
                if (slot >= 0) add_kept_columns(layout, nodes, {static_cast<int>(i), slot}, stiffness);
            }
        }
    }

    struct Column {
        Eigen::Index local;  ///< index of the node in the element
        Eigen::Index slot;   ///< index of the node among the kept nodes
    };

    void add_kept_columns(const sparse::SystemLayout& layout, std::span<const NodeIndex> nodes, Column column,
                          const Eigen::MatrixXd& stiffness) {
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            const auto block = stiffness.block<kDofsPerNode, kDofsPerNode>(
                static_cast<Eigen::Index>(j) * kDofsPerNode, column.local * kDofsPerNode);
            const Eigen::Index slot = task_.slot[nodes[j]];
            if (slot >= 0) {
                kept_stiffness_.block<kDofsPerNode, kDofsPerNode>(slot * kDofsPerNode,
                                                                  column.slot * kDofsPerNode) += block;
                continue;
            }
            for (int d = 0; d < kDofsPerNode; ++d) {
                const int equation = layout.equation(nodes[j].value, d);
                if (equation >= 0)
                    coupling_.row(equation).segment<kDofsPerNode>(column.slot * kDofsPerNode) += block.row(d);
            }
        }
    }

    void eliminate(const sparse::SystemLayout& layout) {
        sparse::Ldlt factors(layout);
        const auto outcome = factors.factorize(values_);
        if (!outcome.positive_definite())
            refuse_inner_mechanism(task_.assembly,
                                   NodeIndex(layout.node_of(std::max(outcome.zero_pivot, 0))));
        Eigen::MatrixXd answer = coupling_;
        factors.solve(answer);
        kept_stiffness_.noalias() -= coupling_.transpose() * answer;
        kept_stiffness_ = 0.5 * (kept_stiffness_ + kept_stiffness_.transpose()).eval();
    }

    const CondensingTask& task_;
    Eigen::MatrixXd kept_stiffness_;
    Eigen::MatrixXd coupling_;
    std::vector<double> values_;
};

}  // namespace

Eigen::MatrixXd condense_sparse(const CondensingTask& task) {
    return SparseCondensation(task).run();
}

}  // namespace fretwork::mechanics::structure
