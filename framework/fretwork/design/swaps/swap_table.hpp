// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace fretwork::design::detail {

/// A table with the change of the residuals of all load cases by every swap. Changes by several swaps are
/// added. The tiles of a *group* are painted together. A *choice* is one column of the table for each group.
struct SwapTable {
    Eigen::VectorXd residual;                ///< residual rho, k coefficients
    double unreached = 0.0;                  ///< constant contribution to the sum of squares
    std::vector<Eigen::MatrixXd> responses;  ///< change of the residual, for each group a matrix of k rows
                                             ///< and one column for each pattern of the table
    Eigen::MatrixXd energies;                ///< energy f . G f of each swap, columns x groups, J
    Eigen::MatrixXd masses;                  ///< mass, columns x groups, kg
    /// Derivatives of the residual, k rows and one column for each continuous unknown.
    Eigen::MatrixXd by_factors;
    Eigen::VectorXd largest_steps;  ///< largest step of each continuous unknown
    double energy = 0.0;            ///< elastic energy of the surface, J

    [[nodiscard]] std::size_t groups() const { return responses.size(); }
    [[nodiscard]] std::size_t columns() const { return static_cast<std::size_t>(energies.rows()); }
};

/// A choice: a column for each group, and steps of the continuous unknowns.
struct Choice {
    std::vector<std::size_t> columns;
    Eigen::VectorXd steps;
    double objective = 0.0;  ///< predicted sum of squares
    double energy = 0.0;     ///< elastic energy of the change, J
    long scored = 0;         ///< number of swaps that were scored to find the choice
};

/// The steps of the continuous unknowns that reduce the residual most, within SwapTable::largest_steps.
Eigen::VectorXd best_steps(const SwapTable& table, const Eigen::VectorXd& residual);

/// An orthonormal basis of the columns of SwapTable::by_factors; no columns if there are no unknowns.
Eigen::MatrixXd unknown_basis(const SwapTable& table);
/// The part of residuals that continuous unknowns cannot remove: the part orthogonal to unknown_basis().
Eigen::MatrixXd left_by_unknowns(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& residuals);

struct SweepOptions {
    std::vector<bool> allowed;  ///< for each column, true if it may be chosen
    double radius = 0.5;        ///< largest energy of the change, as a share of the surface's energy
    double most_mass = 0.0;     ///< largest mass of all groups, kg; 0: any mass
    std::uint64_t seed = 1;
    int proposals = 4000;  ///< number of annealing's proposals for each group; 0: no annealing
    int orders = 3;        ///< number of random orders of the groups that are tried
    base::Control control{};
};

/// Solve the integer least squares problem by sweeps. In a sweep, each group in turn takes its best column
/// while the other groups stay; then the continuous unknowns take their best values. A price on the energy of
/// the change keeps this energy within the radius. Sweeps run in several random orders. If there is no limit
/// on the mass, annealing with single changes continues from the best choice within the radius. Returns the
/// best choice found. Throws Stopped.
Choice sweep(const SwapTable& table, const std::vector<std::size_t>& start, const SweepOptions& options);

/// The choices that differ from the start in one group, followed by the choices that differ in two groups: at
/// most `count` of each kind, in ascending order of the predicted objectives, without steps of the unknowns.
/// The cost is (groups x columns)^2. Throws Stopped.
/// @param allowed  for each column, true if it may be chosen
std::vector<Choice> neighbours(const SwapTable& table, const std::vector<std::size_t>& start,
                               const std::vector<bool>& allowed, std::size_t count,
                               const base::Control& control);

/// Remove columns until a choice has at most `most` different columns. Each removal takes the column that
/// worsens the sweep least. Returns true for each remaining column.
std::vector<bool> fewer_columns(const SwapTable& table, const std::vector<std::size_t>& start,
                                SweepOptions options, std::size_t most);

}  // namespace fretwork::design::detail
