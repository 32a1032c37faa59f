// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/sparse/arbitrary.hpp>
#include <fretwork/mechanics/structure/constraints.hpp>
#include <fretwork/mechanics/structure/free_motion.hpp>
#include <fretwork/mechanics/structure/mechanism.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace fretwork::mechanics::structure {
namespace {

/// The unbalanced share of the load above which only rounding resists the load. Soft structures leave less: a
/// cantilever with the largest number of elements leaves 1e-5, very stiff elements beside soft ones 1e-3.
constexpr double kUnbalancedShare = 1e-2;

/// For each node, true if elements connect it with `from`.
std::vector<bool> connected_to(const Assembly& assembly, NodeIndex from) {
    base::DisjointSets nodes = connected_nodes(assembly);
    const std::size_t wanted = nodes.first_of(from);
    std::vector<bool> connected;
    for (std::size_t node = 0; node < assembly.nodes.size(); ++node)
        connected.push_back(nodes.first_of(node) == wanted);
    return connected;
}

std::string place_text(const Eigen::Vector3d& place) {
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "(%.4g, %.4g, %.4g)", place.x(), place.y(), place.z());
    return text.data();
}

/// Throw the error. The most frequent causes are tested first: nothing is held at all, or a connected part
/// has no support.
[[noreturn]] void refuse(const Assembly& assembly, NodeIndex node) {
    const std::string where = node_text(assembly, node) + ", " + place_text(assembly.nodes[node]);
    const std::vector<bool> connected = connected_to(assembly, node);
    const auto is_beside = [&](const auto& held) { return connected[held.node]; };
    if (std::ranges::none_of(assembly.supports, is_beside) &&
        std::ranges::none_of(assembly.prescribed, is_beside)) {
        const bool is_all = std::ranges::find(connected, false) == connected.end();
        if (is_all)
            throw base::NumericalError({.problem = "nothing holds the structure: it needs supports",
                                        .kind = base::ErrorKind::NothingHeld});
        throw base::NumericalError(
            {.problem = "nothing holds the part of the structure with " + where +
                        ": it needs supports, or beams that connect it with a supported node",
             .kind = base::ErrorKind::PartNotHeld,
             .about = {where}});
    }
    throw base::NumericalError(
        {.problem = "the structure, as held, can move without strain at " + where +
                    ": hold it more, or release less of its beams (or stiffnesses differ by more than "
                    "double precision can represent together)",
         .kind = base::ErrorKind::MovesFreely,
         .about = {where}});
}

}  // namespace

void refuse_mechanisms(const Assembly& assembly, const sparse::SystemLayout& layout,
                       std::span<const double> values, const sparse::Ldlt& factors,
                       const sparse::Ldlt::Outcome& outcome, const base::Control& control) {
    if (!outcome.positive_definite())
        refuse(assembly, NodeIndex(layout.node_of(std::max(outcome.zero_pivot, 0))));
    // Rounding in condensed elements can resist a rigid motion so much that no pivot is weak.
    if (const auto node = freely_moving_node(assembly)) refuse(assembly, *node);
    if (!outcome.has_weak_pivot) return;
    // Loads are scaled by the stiffness of each equation, so that units do not matter.
    Eigen::VectorXd scale(layout.equations());
    for (int i = 0; i < layout.equations(); ++i) scale[i] = std::sqrt(values[layout.column_start()[i]]);
    const Eigen::VectorXd load = scale.cwiseProduct(sparse::arbitrary_numbers(layout.equations()).col(0));
    Eigen::VectorXd displacements = load;
    factors.solve(displacements, control);
    Eigen::VectorXd internal = Eigen::VectorXd::Zero(load.size());
    sparse::add_product(layout, values, displacements, internal);
    const double unbalanced = (load - internal).cwiseQuotient(scale).norm();
    if (unbalanced <= kUnbalancedShare * load.cwiseQuotient(scale).norm()) return;
    Eigen::Index farthest = 0;
    displacements.cwiseProduct(scale).cwiseAbs().maxCoeff(&farthest);
    refuse(assembly, NodeIndex(layout.node_of(static_cast<int>(farthest))));
}

}  // namespace fretwork::mechanics::structure
