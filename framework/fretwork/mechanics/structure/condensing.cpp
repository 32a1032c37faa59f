// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/structure/condensing.hpp>
#include <fretwork/mechanics/structure/constraints.hpp>

#include <string>

namespace fretwork::mechanics::structure {
namespace {

/// The index of each node among the kept nodes; -1 for other nodes.
std::vector<int> slots_of(std::span<const NodeIndex> kept, std::size_t nodes) {
    std::vector<int> slots(nodes, -1);
    int count = 0;
    for (const NodeIndex node : kept) {
        if (node.value < 0 || node.value >= static_cast<int>(nodes))
            throw base::InputError("there is no node " + std::to_string(node.value) + " to condense onto");
        int& slot = slots[node];
        if (slot >= 0)
            throw base::InputError("node " + std::to_string(node.value) + " is to be condensed onto twice");
        slot = count++;
    }
    return slots;
}

}  // namespace

CondensingTask condensing_task(const Assembly& assembly, std::span<const NodeIndex> kept) {
    CondensingTask task{assembly, slots_of(kept, assembly.nodes.size()), {}, static_cast<int>(kept.size())};
    task.inner.assign(assembly.nodes.size(), DofSet::all());
    for (const Support& support : assembly.supports) {
        if (support.node.value < assembly.reported_nodes) continue;  // not a node of a hinge
        auto& contains = task.inner[support.node].contains;
        for (std::size_t d = 0; d < kDofsPerNode; ++d)
            contains[d] = contains[d] && !support.fixed.contains[d];
    }
    for (std::size_t i = 0; i < task.slot.size(); ++i) {
        if (task.slot[i] >= 0) task.inner[i] = DofSet{};
    }
    return task;
}

void refuse_inner_mechanism(const Assembly& assembly, NodeIndex node) {
    throw base::NumericalError(
        "the structure cannot be condensed: while the kept nodes are held, it can move without strain at " +
        node_text(assembly, node));
}

}  // namespace fretwork::mechanics::structure
