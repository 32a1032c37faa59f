// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/filters/filters.hpp>

namespace fretwork::pattern::filters {

// Paper, Section 4.2, "Interface connectivity". With several interface nodes on a side, a pattern must use
// every one of them, because the neighbour's pattern does.
Rule make_no_interface(const NodeLayout& layout, double, const FabricationScale&) {
    CoverRule rule{{}, "no beam ends at"};
    for (const LayoutNodeIndex node : layout.interface_nodes()) {
        EdgeGroup group{"interface node n" + std::to_string(node.value), {}};
        for (std::size_t e = 0; e < layout.candidate_edges().size(); ++e) {
            const Edge& edge = layout.candidate_edges()[e];
            group.edges.set(e, edge.first == node || edge.second == node);
        }
        rule.groups.push_back(std::move(group));
    }
    return rule;
}

}  // namespace fretwork::pattern::filters
