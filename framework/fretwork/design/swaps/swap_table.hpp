// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace fretwork::design::detail {

/// For every swap, the predicted change of the residuals of all load cases. The changes by several swaps are
/// added up. A *group* is a set of tiles that are painted together, such as mirror images. A *column* is a
/// pattern of the table. A *swap* paints a group with a column. A *choice* gives each group a column. The
/// *continuous unknowns* are factors on the loads, prescribed values, and the width and thickness of bars.
struct SwapTable {
    Eigen::VectorXd residual;  ///< residual of all load cases, k coefficients in the bases of the CaseModels
    double unreached = 0.0;    ///< sum of squares outside these bases, kept constant
    std::vector<Eigen::MatrixXd> responses;  ///< change of the residual, for each group a matrix of k rows
                                             ///< and one column for each pattern of the table
    Eigen::MatrixXd energies;  ///< energy f . G f of each swap (SwapAnswer), columns x groups, J
    Eigen::MatrixXd masses;    ///< mass of each group in each column's pattern, columns x groups, kg
    /// Derivatives of the residual, k rows and one column for each continuous unknown.
    Eigen::MatrixXd by_unknowns;
    Eigen::VectorXd largest_steps;  ///< largest step of each continuous unknown
    double energy = 0.0;            ///< elastic energy of the surface, J

    [[nodiscard]] std::size_t groups() const { return responses.size(); }
    [[nodiscard]] std::size_t columns() const { return static_cast<std::size_t>(energies.rows()); }
};

/// A choice: a column for each group, and steps of the continuous unknowns.
struct Choice {
    std::vector<std::size_t> columns;  ///< column of each group
    Eigen::VectorXd steps;             ///< step of each continuous unknown
    double objective = 0.0;            ///< predicted sum of squares
    double energy = 0.0;               ///< elastic energy of the change, J
    long scored = 0;                   ///< number of swaps that sweep() scored; 0 for other searches
};

/// The least squares steps of the continuous unknowns. Each is then clipped to SwapTable::largest_steps.
Eigen::VectorXd best_steps(const SwapTable& table, const Eigen::VectorXd& residual);

/// An orthonormal basis of the space of the columns of SwapTable::by_unknowns; empty if there are no
/// unknowns.
Eigen::MatrixXd unknown_basis(const SwapTable& table);
/// The part of residuals that continuous unknowns cannot remove: the part orthogonal to unknown_basis().
Eigen::MatrixXd left_by_unknowns(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& residuals);

/// Options of sweep().
struct SweepOptions {
    std::vector<bool> allowed;  ///< for each column, true if it may be chosen
    double radius = 0.5;        ///< largest energy of the change, as a share of the surface's energy
    double most_mass = 0.0;     ///< largest total mass of the groups, kg; 0: any mass
    std::uint64_t seed = 1;     ///< seed of the orders of the groups and of annealing
    int proposals = 4000;       ///< number of changes that annealing proposes for each group; 0: no annealing
    int orders = 3;             ///< number of random orders of the groups that are tried
    base::Control control{};
};

/// Search for the choice with the least predicted sum of squares (an integer least squares problem) by
/// sweeps. In a sweep, each group in turn takes its best column while the other groups stay; then the
/// continuous unknowns take their best values. The energy of the change costs a price, high enough to keep
/// this energy within the radius; a second price keeps the mass within SweepOptions::most_mass. If the mass
/// needs no price, sweeps in several random orders follow, and then annealing, which changes one group at a
/// time, from the best choice within the radius. Returns the best choice found. It exceeds a limit if even
/// the highest price tried does not keep it. Throws Stopped.
Choice sweep(const SwapTable& table, const std::vector<std::size_t>& start, const SweepOptions& options);

/// Choices near the start: first those that differ in one group, then those that differ in two. Each kind has
/// at most `count` choices, in ascending order of the predicted objective. Unknowns take no steps. Time and
/// memory grow with (groups x columns)^2. Throws Stopped.
/// @param allowed  for each column, true if it may be chosen
std::vector<Choice> neighbours(const SwapTable& table, const std::vector<std::size_t>& start,
                               const std::vector<bool>& allowed, std::size_t count,
                               const base::Control& control);

/// Remove columns until a choice has at most `most` different columns. First, the columns that a sweep does
/// not use are removed. Then a round sweeps without each of the six least used columns in turn, and removes
/// the one without which the objective is least, together with those that this sweep does not use. Sweeps
/// have one order and no annealing, whatever the options say. Returns true for each remaining column. Throws
/// Stopped.
std::vector<bool> fewer_columns(const SwapTable& table, const std::vector<std::size_t>& start,
                                SweepOptions options, std::size_t most);

}  // namespace fretwork::design::detail
