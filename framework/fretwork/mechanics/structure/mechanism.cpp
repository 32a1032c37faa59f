// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/sparse/arbitrary.hpp>
#include <fretwork/mechanics/structure/constraints.hpp>
#include <fretwork/mechanics/structure/mechanism.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::mechanics::structure {
namespace {

/// Of the load that is left unbalanced where nothing but rounding resists it. Soft structures leave less: a
/// cantilever of as many elements as may be 1e-5, very stiff elements beside soft ones 1e-3.
constexpr double kUnbalancedShare = 1e-2;

[[noreturn]] void refuse(const Assembly& assembly, NodeIndex node) {
    throw base::NumericalError("the structure, as held, can move without strain at " +
                               node_text(assembly, node) +
                               ": hold it more, or release less of its beams (or stiffnesses differ by "
                               "more than double precision tells apart)");
}

}  // namespace

void refuse_mechanisms(const Assembly& assembly, const sparse::SystemLayout& layout,
                       std::span<const double> values, const sparse::Ldlt& factors,
                       const sparse::Ldlt::Outcome& outcome) {
    if (!outcome.positive_definite())
        refuse(assembly, NodeIndex(layout.node_of(std::max(outcome.zero_pivot, 0))));
    if (!outcome.has_weak_pivot) return;
    // By each equation's own stiffness, so that units do not matter.
    Eigen::VectorXd scale(layout.equations());
    for (int i = 0; i < layout.equations(); ++i)
        scale[i] =
            std::sqrt(values[static_cast<std::size_t>(layout.column_start()[static_cast<std::size_t>(i)])]);
    const Eigen::VectorXd load = scale.cwiseProduct(sparse::arbitrary_numbers(layout.equations()).col(0));
    Eigen::VectorXd displacements = load;
    factors.solve(displacements);
    Eigen::VectorXd internal = Eigen::VectorXd::Zero(load.size());
    sparse::add_product(layout, values, displacements, internal);
    const double unbalanced = (load - internal).cwiseQuotient(scale).norm();
    if (unbalanced <= kUnbalancedShare * load.cwiseQuotient(scale).norm()) return;
    Eigen::Index farthest = 0;
    displacements.cwiseProduct(scale).cwiseAbs().maxCoeff(&farthest);
    refuse(assembly, NodeIndex(layout.node_of(static_cast<int>(farthest))));
}

}  // namespace fretwork::mechanics::structure
