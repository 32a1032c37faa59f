// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/sparse/dense_ldlt.hpp>
#include <fretwork/mechanics/structure/condensing.hpp>
#include <fretwork/mechanics/structure/plane_split.hpp>

#include <Eigen/Cholesky>

#include <algorithm>

namespace fretwork::mechanics::structure {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// The stiffness among some dofs of the inner nodes, and between these dofs and the kept dofs.
class Blocks {
  public:
    Blocks(const CondensingTask& task, const DofSet& dofs) : task_(task) {
        Index next = 0;
        for (const DofSet& inner : task.inner) {
            for (std::size_t d = 0; d < kDofsPerNode; ++d)
                rows_.push_back(inner.contains[d] && dofs.contains[d] ? next++ : -1);
        }
        inner_.setZero(next, next);
        coupling_.setZero(next, Index{kDofsPerNode} * task.kept_nodes);
        MatrixXd own;
        for (const auto& element : task.assembly.elements) {
            element->rest_stiffness(own);
            add(element->nodes(), own);
        }
    }

    /// Fill in the rows of these dofs in `result`, which has six rows for each reported inner node.
    void follow(MatrixXd& result) const {
        if (inner_.rows() == 0) return;
        const Eigen::LLT<MatrixXd> factors(inner_);
        if (factors.info() != Eigen::Success || has_zero_pivot(factors)) refuse();
        const MatrixXd moved = -factors.solve(coupling_);
        Index row = 0;  // row of the result
        for (std::size_t node = 0; node < task_.slot.size(); ++node) {
            if (task_.slot[node] >= 0 || static_cast<int>(node) >= task_.assembly.reported_nodes) continue;
            for (Index d = 0; d < kDofsPerNode; ++d) {
                const Index from = rows_[node * kDofsPerNode + d];
                if (from >= 0) result.row(row + d) = moved.row(from);
            }
            row += kDofsPerNode;
        }
    }

  private:
    /// The place of a dof: the row of an inner dof, or the column of a kept dof.
    struct Place {
        Index inner;
        Index kept;
    };
    [[nodiscard]] std::vector<Place> places(std::span<const NodeIndex> nodes) const {
        std::vector<Place> result;
        for (const NodeIndex node : nodes) {
            const std::size_t n = node;
            for (Index d = 0; d < kDofsPerNode; ++d) {
                const Index kept = task_.slot[n] < 0 ? -1 : task_.slot[n] * Index{kDofsPerNode} + d;
                result.push_back({rows_[n * kDofsPerNode + d], kept});
            }
        }
        return result;
    }

    void add(std::span<const NodeIndex> nodes, const MatrixXd& own) {
        const std::vector<Place> at = places(nodes);
        for (std::size_t j = 0; j < at.size(); ++j) {
            for (std::size_t i = 0; i < at.size(); ++i) {
                const double value = own(static_cast<Index>(i), static_cast<Index>(j));
                if (at[i].inner < 0) continue;
                if (at[j].inner >= 0) inner_(at[i].inner, at[j].inner) += value;
                if (at[j].kept >= 0) coupling_(at[i].inner, at[j].kept) += value;
            }
        }
    }

    /// True if a pivot counts as zero, as in condense_dense(): that of a mechanism is rounding of either
    /// sign.
    [[nodiscard]] bool has_zero_pivot(const Eigen::LLT<MatrixXd>& factors) const {
        const auto pivots = factors.matrixLLT().diagonal().array().square();
        return (pivots <= sparse::kZeroPivot * inner_.diagonal().array()).any();
    }

    [[noreturn]] void refuse() const {
        const auto first = std::ranges::find(task_.slot, -1);
        refuse_inner_mechanism(task_.assembly, NodeIndex(first - task_.slot.begin()));
    }

    const CondensingTask& task_;
    std::vector<Index> rows_;  ///< row of each dof of the structure; -1: not among these dofs
    MatrixXd inner_;
    MatrixXd coupling_;
};

/// True if membrane and bending can be solved separately.
bool is_split(const Assembly& assembly) {
    if (!is_flat(assembly)) return false;
    MatrixXd own;
    return std::ranges::all_of(assembly.elements, [&](const auto& element) {
        element->rest_stiffness(own);
        return decouples(own);
    });
}

}  // namespace

Eigen::MatrixXd following(const CondensingTask& task) {
    const auto inner_nodes =
        std::count(task.slot.begin(), task.slot.begin() + task.assembly.reported_nodes, -1);
    MatrixXd result = MatrixXd::Zero(kDofsPerNode * inner_nodes, Index{kDofsPerNode} * task.kept_nodes);
    if (!is_split(task.assembly)) {
        Blocks(task, DofSet::all()).follow(result);
        return result;
    }
    Blocks(task, kInPlane).follow(result);
    Blocks(task, kOutOfPlane).follow(result);
    return result;
}

}  // namespace fretwork::mechanics::structure
