// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/index.hpp>
#include <fretwork/mechanics/sparse/dense_ldlt.hpp>
#include <fretwork/mechanics/structure/condensing.hpp>
#include <fretwork/mechanics/structure/plane_split.hpp>

#include <algorithm>
#include <optional>

namespace fretwork::mechanics::structure {
namespace {

using base::at;

/// A set of dofs: all dofs, those of the membrane, or those of bending. Its inner dofs are eliminated in one
/// dense front.
class Part {
  public:
    Part(const CondensingTask& task, const DofSet& dofs)
        : task_(task), equation_(kDofsPerNode * task.slot.size(), -1) {
        for_each_dof(dofs, [&](int node, int d) {
            if (task.inner[at(node)].contains[at(d)]) number(node, d, node_of_inner_, NodeIndex(node));
        });
        inner_ = static_cast<int>(node_of_inner_.size());
        for_each_dof(dofs, [&](int node, int d) {
            if (task.slot[at(node)] >= 0) number(node, d, kept_dof_, task.slot[at(node)] * kDofsPerNode + d);
        });
        const auto kept = static_cast<Eigen::Index>(kept_dof_.size());
        panel_.setZero(inner_ + kept, inner_);
        kept_.setZero(kept, kept);
    }

    /// Add the stiffness of an element to the lower triangle.
    void add(std::span<const NodeIndex> nodes, const Eigen::MatrixXd& stiffness) {
        local_.clear();
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            for (int d = 0; d < kDofsPerNode; ++d) {
                const int equation = equation_[at(nodes[i].value * kDofsPerNode + d)];
                if (equation >= 0) local_.push_back({static_cast<int>(i) * kDofsPerNode + d, equation});
            }
        }
        for (const Local& column : local_) {
            for (const Local& row : local_) {
                if (row.equation < column.equation) continue;
                const double value = stiffness(row.dof, column.dof);
                if (column.equation < inner_) {
                    panel_(row.equation, column.equation) += value;
                } else {
                    kept_(row.equation - inner_, column.equation - inner_) += value;
                }
            }
        }
    }

    /// Eliminate the inner dofs, and write the condensed stiffness of the kept dofs.
    void condense_into(Eigen::MatrixXd& result) {
        if (inner_ > 0) eliminate_inner();
        for (std::size_t j = 0; j < kept_dof_.size(); ++j) {
            for (std::size_t i = j; i < kept_dof_.size(); ++i) {
                const double value = kept_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
                result(kept_dof_[i], kept_dof_[j]) = result(kept_dof_[j], kept_dof_[i]) = value;
            }
        }
    }

  private:
    struct Local {
        int dof;  ///< row of the element's stiffness
        int equation;
    };

    template <class Body>
    void for_each_dof(const DofSet& dofs, const Body& body) const {
        for (int node = 0; node < static_cast<int>(task_.slot.size()); ++node) {
            for (int d = 0; d < kDofsPerNode; ++d) {
                if (dofs.contains[at(d)]) body(node, d);
            }
        }
    }

    template <class List, class Value>
    void number(int node, int d, List& list, Value value) {
        equation_[at(node * kDofsPerNode + d)] = equations_++;
        list.push_back(value);
    }

    void eliminate_inner() {
        const Eigen::VectorXd diagonal = panel_.diagonal();
        sparse::require_finite({diagonal.data(), node_of_inner_.size()});
        const auto kept = static_cast<int>(kept_.rows());
        Eigen::MatrixXd rest(kept, kept);
        std::vector<double> scratch;
        const sparse::Pivots pivots =
            sparse::eliminate({inner_, kept, panel_.data(), rest.data()},
                              {{diagonal.data(), node_of_inner_.size()}, sparse::kZeroPivot}, scratch);
        if (pivots.zero >= 0 || pivots.negative > 0)
            refuse_inner_mechanism(task_.assembly, node_of_inner_[at(std::max(pivots.zero, 0))]);
        kept_ += rest;
    }

    const CondensingTask& task_;
    std::vector<int>
        equation_;  ///< equation of dof d of node i, at 6 i + d; inner dofs come first; -1: not in this part
    std::vector<NodeIndex> node_of_inner_;
    std::vector<int> kept_dof_;  ///< rows of the kept dofs in the result
    int inner_ = 0;
    int equations_ = 0;
    Eigen::MatrixXd panel_;  ///< columns of the inner dofs
    Eigen::MatrixXd kept_;   ///< block of the kept dofs
    std::vector<Local> local_;
};

/// The stiffness, condensed part by part; nothing if an element couples the parts.
std::optional<Eigen::MatrixXd> condense_parts(const CondensingTask& task, std::span<const DofSet> dofs) {
    std::vector<Part> parts;
    for (const DofSet& part : dofs) parts.emplace_back(task, part);
    Eigen::MatrixXd stiffness;
    for (const auto& element : task.assembly.elements) {
        element->rest_stiffness(stiffness);
        if (parts.size() > 1 && !decouples(stiffness)) return std::nullopt;
        for (Part& part : parts) part.add(element->nodes(), stiffness);
    }
    const Eigen::Index size = Eigen::Index{kDofsPerNode} * task.kept_nodes;
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size, size);
    for (Part& part : parts) part.condense_into(result);
    return result;
}

}  // namespace

Eigen::MatrixXd condense_dense(const CondensingTask& task) {
    if (is_flat(task.assembly)) {
        const DofSet halves[] = {kInPlane, kOutOfPlane};
        if (auto result = condense_parts(task, halves)) return *std::move(result);
    }
    const DofSet whole[] = {DofSet::all()};
    return *condense_parts(task, whole);
}

}  // namespace fretwork::mechanics::structure
