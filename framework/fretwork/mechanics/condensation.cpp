// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/elements/linear_element.hpp>
#include <fretwork/mechanics/sparse/ldlt.hpp>
#include <fretwork/mechanics/structure/constraints.hpp>
#include <fretwork/mechanics/structure/coupling.hpp>

#include <string>

namespace fretwork::mechanics {
namespace {

class Condensation {
  public:
    Condensation(const Assembly& assembly, std::span<const NodeIndex> kept)
        : assembly_(assembly), slot_(assembly.nodes.size(), -1) {
        for (const NodeIndex node : kept) {
            if (node.value < 0 || node.value >= static_cast<int>(slot_.size()))
                throw base::InputError("there is no node " + std::to_string(node.value) +
                                       " to condense onto");
            int& slot = slot_[static_cast<std::size_t>(node.value)];
            if (slot >= 0)
                throw base::InputError("node " + std::to_string(node.value) +
                                       " is to be condensed onto twice");
            slot = slots_++;
        }
    }

    Eigen::MatrixXd run() {
        const std::vector<sparse::Components> free = structure::components(inner_dofs());
        const sparse::NodeGraph graph = structure::coupling_graph(assembly_);
        const sparse::SystemLayout layout(graph, free, sparse::elimination_order(graph, free));
        assemble(layout);
        if (layout.equations() > 0) eliminate(layout);
        return std::move(kept_stiffness_);
    }

  private:
    /// All dofs of the nodes that go, but for those that hinges hold for themselves.
    [[nodiscard]] std::vector<DofSet> inner_dofs() const {
        std::vector<DofSet> free(slot_.size(), DofSet::all());
        for (const Support& support : assembly_.supports) {
            if (support.node.value < assembly_.reported_nodes) continue;
            auto& contains = free[static_cast<std::size_t>(support.node.value)].contains;
            for (std::size_t d = 0; d < kDofsPerNode; ++d)
                contains[d] = contains[d] && !support.fixed.contains[d];
        }
        for (std::size_t i = 0; i < slot_.size(); ++i) {
            if (slot_[i] >= 0) free[i] = DofSet{};
        }
        return free;
    }

    void assemble(const sparse::SystemLayout& layout) {
        const Eigen::Index size = static_cast<Eigen::Index>(slots_) * kDofsPerNode;
        kept_stiffness_.setZero(size, size);
        coupling_.setZero(layout.equations(), size);
        values_.assign(layout.row().size(), 0.0);
        Eigen::MatrixXd stiffness;
        for (std::size_t e = 0; e < assembly_.elements.size(); ++e) {
            const auto nodes = assembly_.elements[e]->nodes();
            assembly_.elements[e]->rest_stiffness(stiffness);
            layout.add(e, stiffness, values_);
            for (std::size_t i = 0; i < nodes.size(); ++i) {
                const int slot = slot_[static_cast<std::size_t>(nodes[i].value)];
                if (slot >= 0) add_kept_columns(layout, nodes, {static_cast<int>(i), slot}, stiffness);
            }
        }
    }

    struct Column {
        Eigen::Index local;  ///< place of the node in the element
        Eigen::Index slot;   ///< place of the node among the kept
    };

    void add_kept_columns(const sparse::SystemLayout& layout, std::span<const NodeIndex> nodes, Column column,
                          const Eigen::MatrixXd& stiffness) {
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            const auto block = stiffness.block<kDofsPerNode, kDofsPerNode>(
                static_cast<Eigen::Index>(j) * kDofsPerNode, column.local * kDofsPerNode);
            const Eigen::Index slot = slot_[static_cast<std::size_t>(nodes[j].value)];
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
        if (!outcome.positive_definite()) {
            throw base::NumericalError(
                "the structure cannot be condensed: while the kept nodes are held, it can move without "
                "strain at " +
                structure::node_text(assembly_, NodeIndex(layout.node_of(std::max(outcome.zero_pivot, 0)))));
        }
        Eigen::MatrixXd answer = coupling_;
        factors.solve(answer);
        kept_stiffness_.noalias() -= coupling_.transpose() * answer;
        kept_stiffness_ = 0.5 * (kept_stiffness_ + kept_stiffness_.transpose()).eval();
    }

    const Assembly& assembly_;
    std::vector<int> slot_;
    int slots_ = 0;
    Eigen::MatrixXd kept_stiffness_;
    Eigen::MatrixXd coupling_;
    std::vector<double> values_;
};

}  // namespace

Eigen::MatrixXd condense(const Assembly& assembly, std::span<const NodeIndex> kept) {
    return Condensation(assembly, kept).run();
}

std::unique_ptr<const Element> linear_element(std::vector<NodeIndex> nodes, Eigen::MatrixXd stiffness) {
    const auto size = static_cast<Eigen::Index>(nodes.size()) * kDofsPerNode;
    if (stiffness.rows() != size || stiffness.cols() != size)
        throw base::InputError("an element of " + std::to_string(nodes.size()) +
                               " nodes needs a stiffness of " + std::to_string(size) +
                               " rows and columns, not " + std::to_string(stiffness.rows()) + " x " +
                               std::to_string(stiffness.cols()));
    return std::make_unique<elements::LinearElement>(std::move(nodes), std::move(stiffness));
}

}  // namespace fretwork::mechanics
