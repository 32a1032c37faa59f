// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/condensation.hpp>
#include <fretwork/mechanics/structure/condensing.hpp>
#include <fretwork/mechanics/structure/plane_split.hpp>

#include <string>

namespace fretwork::mechanics {
namespace {

/// The largest number of unknowns for dense elimination. With more unknowns, sparse elimination is faster
/// (bench/mechanics_bench: condense_by).
constexpr std::ptrdiff_t kFewEquations = 144;

bool is_small(const Assembly& assembly, std::span<const NodeIndex> kept) {
    const std::ptrdiff_t inner = std::ssize(assembly.nodes) - std::ssize(kept);
    return inner * (structure::is_flat(assembly) ? kDofsPerNode / 2 : kDofsPerNode) <= kFewEquations;
}

}  // namespace

std::vector<NodeIndex> first_nodes(int count) {
    std::vector<NodeIndex> nodes;
    for (int i = 0; i < count; ++i) nodes.emplace_back(i);
    return nodes;
}

Eigen::MatrixXd condense(const Assembly& assembly, std::span<const NodeIndex> kept) {
    const structure::CondensingTask task = structure::condensing_task(assembly, kept);
    return is_small(assembly, kept) ? structure::condense_dense(task) : structure::condense_sparse(task);
}

Eigen::MatrixXd condense_mass(const Assembly& assembly, std::span<const NodeIndex> kept) {
    return structure::condense_mass(structure::condensing_task(assembly, kept));
}

Eigen::MatrixXd following(const Assembly& assembly, std::span<const NodeIndex> kept) {
    return structure::following(structure::condensing_task(assembly, kept));
}

}  // namespace fretwork::mechanics
