// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/reduction/detail/scenario_loads.hpp>
#include <fretwork/reduction/unit_displacements.hpp>

#include <Eigen/Cholesky>

namespace fretwork::reduction {
namespace {

std::vector<Eigen::Index> free_dofs(const Scenario& scenario, Eigen::Index count) {
    std::vector<bool> held(count, false);
    for (const mechanics::Support& support : detail::supports_of(scenario)) {
        for (std::size_t dof = 0; dof < support.fixed.contains.size(); ++dof) {
            if (support.fixed.contains[dof]) held[6 * support.node + dof] = true;
        }
    }
    std::vector<Eigen::Index> result;
    for (Eigen::Index dof = 0; dof < count; ++dof) {
        if (!held[dof]) result.push_back(dof);
    }
    return result;
}

mechanics::NodeValues unit_loads(const Scenario& scenario, Eigen::Index nodes) {
    mechanics::NodeValues loads = mechanics::NodeValues::Zero(nodes, mechanics::kDofsPerNode);
    for (const mechanics::NodalLoad& load : detail::loads_of(scenario, 1.0)) {
        loads.row(load.node).head<3>() += load.force;
        loads.row(load.node).tail<3>() += load.moment;
    }
    return loads;
}

mechanics::NodeValues solve_scenario(const Eigen::MatrixXd& stiffness, const Scenario& scenario) {
    /// The smallest reciprocal condition of a structure that is held. Held structures have about 1e-8, and
    /// free structures have the size of round-off.
    constexpr double kSmallestConditioning = 1e-13;
    const std::vector<Eigen::Index> free = free_dofs(scenario, stiffness.rows());
    const Eigen::LDLT<Eigen::MatrixXd> factor(Eigen::MatrixXd(stiffness(free, free)));
    if (!factor.isPositive() || factor.rcond() < kSmallestConditioning) {
        throw base::NumericalError("scenario '" + scenario.name + "' lets the tile move freely");
    }
    const Eigen::Index nodes = stiffness.rows() / mechanics::kDofsPerNode;
    const mechanics::NodeValues loads = unit_loads(scenario, nodes);
    const Eigen::VectorXd load = loads.reshaped<Eigen::RowMajor>();
    const Eigen::VectorXd free_load = load(free);
    const Eigen::VectorXd solution = factor.solve(free_load);
    Eigen::VectorXd displacements = Eigen::VectorXd::Zero(stiffness.rows());
    displacements(free) = solution;
    return displacements.reshaped<Eigen::RowMajor>(nodes, mechanics::kDofsPerNode);
}

}  // namespace

UnitDisplacements unit_displacements(const Eigen::MatrixXd& stiffness, const Setting& setting) {
    const auto nodes_a_side = static_cast<int>(stiffness.rows()) / (mechanics::kDofsPerNode * setting.sides);
    UnitDisplacements result;
    for (const Scenario& scenario : setting.scenarios)
        result.push_back(solve_scenario(stiffness, spread_over_sides(scenario, nodes_a_side)));
    return result;
}

}  // namespace fretwork::reduction
