// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/internal/mode_count.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/nonlinear/nonlinear_system.hpp>
#include <fretwork/mechanics/structure/constraints.hpp>
#include <fretwork/mechanics/structure/mechanism.hpp>
#include <fretwork/mechanics/structure/subspace_iteration.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace fretwork::mechanics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The entry with the largest absolute value, with its sign.
double largest_entry(const Eigen::Ref<const MatrixXd>& values) {
    Eigen::Index row = 0;
    Eigen::Index column = 0;
    values.cwiseAbs().maxCoeff(&row, &column);
    return values(row, column);
}

/// The factors of the stiffness of a structure at rest. Throws NumericalError for a mechanism.
sparse::Ldlt factorize_at_rest(const nonlinear::NonlinearSystem& system, const base::Control& control) {
    sparse::Ldlt factors(system.unknowns().layout(), 1, control);
    const auto outcome = factors.factorize(system.tangent(), control);
    structure::refuse_mechanisms(system.unknowns().assembly(), system.unknowns().layout(), system.tangent(),
                                 factors, outcome, control);
    return factors;
}

Mode make_mode(const nonlinear::NonlinearSystem& system, double value, const VectorXd& vector) {
    NodeValues table =
        NodeValues::Zero(static_cast<Eigen::Index>(system.unknowns().assembly().nodes.size()), kDofsPerNode);
    system.unknowns().layout().scatter(vector, table);
    const Eigen::Index reported = system.unknowns().assembly().reported_nodes;
    const double turn = largest_entry(table.rightCols<3>());
    const double move = largest_entry(table.leftCols<3>());
    constexpr double kOnlyTurns = 1e-9;
    table /= std::abs(move) > kOnlyTurns * structure::characteristic_length(system.unknowns().assembly()) *
                                  std::abs(turn)
                 ? move
                 : turn;
    return {value, table.topRows(reported), table.bottomRows(table.rows() - reported)};
}

std::vector<double> mass_values(const nonlinear::NonlinearSystem& system, const base::Control& control) {
    std::vector<double> values(system.unknowns().layout().row().size(), 0.0);
    MatrixXd mass;
    bool has_mass = false;
    const Assembly& assembly = system.unknowns().assembly();
    for (std::size_t e = 0; e < assembly.elements.size(); ++e) {
        control.check();
        assembly.elements[e]->mass(mass);
        has_mass = has_mass || !mass.isZero(0.0);
        system.unknowns().layout().add(e, mass, values);
    }
    if (!has_mass)
        throw base::InputError("the structure has no mass to vibrate: give its materials a density");
    return values;
}

/// The displacements of an element's nodes as one column.
VectorXd element_displacements(const Element& element, const NodeValues& displacements) {
    const auto nodes = element.nodes();
    VectorXd own(static_cast<Eigen::Index>(nodes.size()) * kDofsPerNode);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        own.segment<kDofsPerNode>(static_cast<Eigen::Index>(i) * kDofsPerNode) =
            displacements.row(nodes[i].value).transpose();
    return own;
}

/// True if supports move the structure as a rigid body, so that all forces are rounding of terms that cancel.
/// The displacements come from a factorization, and leave forces of about ten units of rounding.
bool is_moved_rigidly(const Assembly& assembly, const NodeValues& displacements,
                      const base::Control& control) {
    constexpr double kRounding = 1e3 * std::numeric_limits<double>::epsilon();
    if (!assembly.loads.isZero(0.0)) return false;
    double forces = 0.0;
    double terms = 0.0;
    MatrixXd stiffness;
    for (const auto& element : assembly.elements) {
        control.check();
        const VectorXd own = element_displacements(*element, displacements);
        element->rest_stiffness(stiffness);
        forces += (stiffness * own).squaredNorm();
        terms += (stiffness.cwiseAbs() * own.cwiseAbs()).squaredNorm();
    }
    return std::sqrt(forces) <= kRounding * std::sqrt(terms);
}

/// The negative geometric stiffness of linear displacements.
std::vector<double> softening(const nonlinear::NonlinearSystem& system, const NodeValues& displacements,
                              const base::Control& control) {
    const Assembly& assembly = system.unknowns().assembly();
    std::vector<double> values(system.unknowns().layout().row().size(), 0.0);
    MatrixXd stiffness;
    for (std::size_t e = 0; e < assembly.elements.size(); ++e) {
        control.check();
        const Element& element = *assembly.elements[e];
        element.geometric_stiffness(element_displacements(element, displacements), stiffness);
        stiffness = -stiffness;
        system.unknowns().layout().add(e, stiffness, values);
    }
    return values;
}

}  // namespace

std::vector<Mode> vibration_modes(const Assembly& assembly, int count, const ModeOptions& options) {
    check_mode_count(count, 1);
    nonlinear::NonlinearSystem system(assembly, 1, options.control);
    system.evaluate(system.unknowns().rest(), 0.0);
    std::vector<double> masses = mass_values(system, options.control);
    const auto pairs =
        structure::SubspaceIteration(system.unknowns().layout(), {system.tangent(), std::move(masses)},
                                     factorize_at_rest(system, options.control), options.control)
            .largest(count);
    std::vector<Mode> modes;
    for (Eigen::Index i = 0; i < pairs.values.size(); ++i) {
        if (pairs.values[i] <= 0.0) break;
        const double frequency = 1.0 / (2.0 * std::numbers::pi * std::sqrt(pairs.values[i]));
        modes.push_back(make_mode(system, frequency, pairs.vectors.col(i)));
    }
    return modes;
}

std::vector<Mode> buckling_modes(const Assembly& assembly, int count, const ModeOptions& options) {
    check_mode_count(count, 1);
    nonlinear::NonlinearSystem system(assembly, 1, options.control);
    system.evaluate(system.unknowns().rest(), 0.0);
    sparse::Ldlt factors = factorize_at_rest(system, options.control);
    VectorXd rate = system.load_rate();
    factors.solve(rate, options.control);
    NodeValues displacements = structure::constraints_of(assembly).values;
    system.unknowns().layout().scatter(rate, displacements);
    if (is_moved_rigidly(assembly, displacements, options.control)) return {};
    const auto pairs =
        structure::SubspaceIteration(system.unknowns().layout(),
                                     {system.tangent(), softening(system, displacements, options.control)},
                                     std::move(factors), options.control)
            .largest_positive(count);
    std::vector<Mode> modes;
    for (Eigen::Index i = 0; i < pairs.values.size(); ++i)
        modes.push_back(make_mode(system, 1.0 / pairs.values[i], pairs.vectors.col(i)));
    return modes;
}

std::string missing_vibration_modes_text(std::ptrdiff_t found, int wanted) {
    if (found >= wanted) return "";
    if (found == 0) return "no natural frequency: everything that has mass is held";
    return "no more than " + std::to_string(found) +
           " natural frequencies: no more components with mass are free";
}

std::string missing_buckling_modes_text(std::ptrdiff_t found, int wanted) {
    if (found >= wanted) return "";
    if (found == 0)
        return "no buckling load: nothing is loaded, or only the reversed load makes anything buckle";
    return "no more than " + std::to_string(found) +
           " buckling loads: the others, if any, are of reversed loads";
}

}  // namespace fretwork::mechanics
