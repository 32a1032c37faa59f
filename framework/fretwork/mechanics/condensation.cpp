// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/elements/linear_element.hpp>
#include <fretwork/mechanics/structure/condensing.hpp>
#include <fretwork/mechanics/structure/plane_split.hpp>

#include <string>

namespace fretwork::mechanics {
namespace {

/// Of a dense front. With more, sparse elimination is faster (bench/mechanics_bench: condense_by).
constexpr std::ptrdiff_t kFewEquations = 144;

bool is_small(const Assembly& assembly, std::span<const NodeIndex> kept) {
    const std::ptrdiff_t inner = std::ssize(assembly.nodes) - std::ssize(kept);
    return inner * (structure::is_flat(assembly) ? kDofsPerNode / 2 : kDofsPerNode) <= kFewEquations;
}

}  // namespace

Eigen::MatrixXd condense(const Assembly& assembly, std::span<const NodeIndex> kept) {
    const structure::CondensingTask task = structure::condensing_task(assembly, kept);
    return is_small(assembly, kept) ? structure::condense_dense(task) : structure::condense_sparse(task);
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
