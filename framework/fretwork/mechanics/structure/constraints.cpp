// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/structure/constraints.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretwork::mechanics::structure {

std::vector<DofSet> held_dofs(const Assembly& assembly) {
    std::vector<DofSet> held(assembly.nodes.size());
    for (const Support& support : assembly.supports) held[support.node] |= support.fixed;
    for (const PrescribedDisplacement& given : assembly.prescribed) held[given.node][given.dof] = true;
    return held;
}

Constraints constraints_of(const Assembly& assembly) {
    Constraints constraints;
    constraints.held = held_dofs(assembly);
    constraints.values = NodeValues::Zero(static_cast<Eigen::Index>(assembly.nodes.size()), kDofsPerNode);
    for (const PrescribedDisplacement& given : assembly.prescribed) {
        constraints.values(given.node.value, static_cast<Eigen::Index>(given.dof)) = given.value;
    }
    return constraints;
}

base::DisjointSets connected_nodes(const Assembly& assembly) {
    base::DisjointSets sets(assembly.nodes.size());
    for (const auto& element : assembly.elements) {
        const std::size_t first = element->nodes().front();
        for (const NodeIndex node : element->nodes()) sets.unite(first, node);
    }
    return sets;
}

NodeIndex nearest_reported(const Assembly& assembly, NodeIndex node) {
    NodeIndex nearest;
    double least = std::numeric_limits<double>::max();
    for (int i = 0; i < assembly.reported_nodes; ++i) {
        const double distance = (assembly.nodes[i] - assembly.nodes[node]).squaredNorm();
        if (distance < least) {
            least = distance;
            nearest = NodeIndex(i);
        }
    }
    return nearest;
}

std::string node_text(const Assembly& assembly, NodeIndex node) {
    const auto name_of = [&](int reported) {
        const int label = assembly.labels.empty() ? reported : assembly.labels[reported];
        return "node " + std::to_string(label);
    };
    if (node.value < assembly.reported_nodes) return name_of(node.value);
    return "the inside or hinge of a beam at " + name_of(nearest_reported(assembly, node).value);
}

double characteristic_length(const Assembly& assembly) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const auto& element : assembly.elements) {
        const auto nodes = element->nodes();
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            const double distance = (assembly.nodes[nodes[i]] - assembly.nodes[nodes[0]]).norm();
            sum += distance;
            count += distance > 0 ? 1 : 0;
        }
    }
    return count > 0 ? sum / static_cast<double>(count) : 1.0;
}

double force_norm(const NodeValues& forces, double length) {
    return std::sqrt(forces.leftCols<3>().squaredNorm() +
                     forces.rightCols<3>().squaredNorm() / (length * length));
}

}  // namespace fretwork::mechanics::structure
