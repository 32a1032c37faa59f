// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/reduction/model_catalogue.hpp>
#include <fretwork/reduction/objective.hpp>

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>

namespace fretwork::reduction {
namespace {

Calibration calibrate(const PatternCase& input, const CalibrationOptions& options) {
    return calibrate_paper6(input.responses, input.setting, options);
}

Calibration compare_condensed(const PatternCase& input, const CalibrationOptions&) {
    const Setting& setting = input.setting;
    const Eigen::MatrixXd stiffness = condensed_tile(
        input.layout, input.pattern, pattern::regular_polygon(setting.sides, setting.tile_side),
        {setting.section, setting.material});
    const UnitDisplacements model = stiffness_displacements(stiffness, setting);
    const Objective objective(input.responses, setting);
    Calibration result;
    result.model = "condensed";
    result.optimizer = "none";
    result.objective = objective.value(model);
    result.scenario_errors = objective.scenario_errors(model);
    return result;
}

constexpr std::array kRows = {
    ReducedModelRow{"paper6", "The paper's hexagon with links: six parameters, calibrated",
                    Preparation::Calibration, calibrate},
    ReducedModelRow{"condensed", "The pattern's own linear frame, condensed onto its interface nodes",
                    Preparation::None, compare_condensed},
};

std::vector<Eigen::Index> free_dofs(const Scenario& scenario, Eigen::Index count) {
    std::vector<bool> held(static_cast<std::size_t>(count), false);
    for (const Scenario::Hold& hold : scenario.held) {
        for (std::size_t dof = 0; dof < hold.fixed.contains.size(); ++dof) {
            if (hold.fixed.contains[dof])
                held[6 * static_cast<std::size_t>(hold.interface_node) + dof] = true;
        }
    }
    std::vector<Eigen::Index> result;
    for (Eigen::Index dof = 0; dof < count; ++dof) {
        if (!held[static_cast<std::size_t>(dof)]) result.push_back(dof);
    }
    return result;
}

mechanics::NodeValues unit_loads(const Scenario& scenario, int sides) {
    mechanics::NodeValues loads = mechanics::NodeValues::Zero(sides, mechanics::kDofsPerNode);
    for (const Scenario::Load& load : scenario.loads) {
        for (int axis = 0; axis < 3; ++axis) {
            loads(load.interface_node, axis) += load.force[static_cast<std::size_t>(axis)];
            loads(load.interface_node, 3 + axis) += load.moment[static_cast<std::size_t>(axis)];
        }
    }
    return loads;
}

mechanics::NodeValues solve_scenario(const Eigen::MatrixXd& stiffness, const Scenario& scenario, int sides) {
    /// A structure that is held has some 1e-8, one that is not has round-off.
    constexpr double kSmallestConditioning = 1e-13;
    const std::vector<Eigen::Index> free = free_dofs(scenario, stiffness.rows());
    const Eigen::LDLT<Eigen::MatrixXd> factor(Eigen::MatrixXd(stiffness(free, free)));
    if (!factor.isPositive() || factor.rcond() < kSmallestConditioning) {
        throw base::NumericalError("scenario '" + scenario.name + "' lets the tile move freely");
    }
    const mechanics::NodeValues loads = unit_loads(scenario, sides);
    const Eigen::VectorXd load = loads.reshaped<Eigen::RowMajor>();
    const Eigen::VectorXd free_load = load(free);
    const Eigen::VectorXd solution = factor.solve(free_load);
    Eigen::VectorXd displacements = Eigen::VectorXd::Zero(stiffness.rows());
    displacements(free) = solution;
    return displacements.reshaped<Eigen::RowMajor>(sides, mechanics::kDofsPerNode);
}

}  // namespace

std::span<const ReducedModelRow> reduced_model_catalogue() {
    return kRows;
}

const ReducedModelRow& find_reduced_model(std::string_view name) {
    const auto row = std::ranges::find(kRows, name, &ReducedModelRow::name);
    if (row != kRows.end()) return *row;
    std::vector<std::string> names;
    for (const ReducedModelRow& candidate : kRows) names.emplace_back(candidate.name);
    throw base::InputError(base::unknown_name_message("reduced model", name, names));
}

UnitDisplacements stiffness_displacements(const Eigen::MatrixXd& stiffness, const Setting& setting) {
    UnitDisplacements result;
    for (const Scenario& scenario : setting.scenarios) {
        result.push_back(solve_scenario(stiffness, scenario, setting.sides));
    }
    return result;
}

}  // namespace fretwork::reduction
