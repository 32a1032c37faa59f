// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace fretwork::design::detail {

/// The change of all load cases' residuals by every swap; changes by several swaps are added. The tiles of a
/// *group* are painted together. A *choice* is one column of the table for each group.
struct SwapTable {
    Eigen::VectorXd residual;  ///< rho, k coefficients
    double unreached = 0.0;    ///< the contribution to the sum of squares that no choice changes
    std::vector<Eigen::MatrixXd>
        responses;                  ///< for each group k rows and a column for each pattern of the table
    Eigen::MatrixXd energies;       ///< f . G f, columns x groups, J
    Eigen::MatrixXd masses;         ///< kg, columns x groups
    Eigen::MatrixXd by_factors;     ///< k rows; a column for each continuous unknown
    Eigen::VectorXd largest_steps;  ///< largest step of each continuous unknown
    double energy = 0.0;            ///< elastic energy of the surface, J

    [[nodiscard]] std::size_t groups() const { return responses.size(); }
    [[nodiscard]] std::size_t columns() const { return static_cast<std::size_t>(energies.rows()); }
};

/// A column for each group, and steps of the continuous unknowns.
struct Choice {
    std::vector<std::size_t> columns;
    Eigen::VectorXd steps;
    double objective = 0.0;  ///< the predicted sum of squares
    double energy = 0.0;     ///< elastic energy of the change, J
    long scored = 0;         ///< swaps that were scored on the way
};

/// The steps of the continuous unknowns from zero that lessen a residual the most, each at most as large as
/// its largest step.
Eigen::VectorXd best_steps(const SwapTable& table, const Eigen::VectorXd& residual);

struct SweepOptions {
    std::vector<bool> allowed;  ///< for each column, whether it may be chosen
    double radius = 0.5;        ///< the energy of the change is at most this share of the surface's
    double most_mass = 0.0;     ///< kg, of all groups; 0: any
    std::uint64_t seed = 1;
    int proposals = 4000;  ///< of annealing on the table, for each group; 0: none
    int orders = 3;        ///< random orders of the groups that are tried
    base::Control control{};
};

/// Solve the integer least squares problem by sweeps. Each group in turn takes its best column while the
/// other groups stay; then the continuous unknowns take their best values. A price on the energy of the
/// change keeps it within the radius. Sweeps run in several random orders. From the best choice, annealing
/// with single changes goes on within the radius, if there is no limit on the mass. Returns the best choice
/// found. Throws Stopped.
Choice sweep(const SwapTable& table, const std::vector<std::size_t>& start, const SweepOptions& options);

/// The choices that differ from the start in one group, and then those that differ in two, each in the order
/// of their predicted objectives, the least first: at most `count` of each, without steps of the unknowns.
/// Cost: (groups x columns)^2. Throws Stopped.
/// @param allowed  for each column, whether it may be chosen
std::vector<Choice> neighbours(const SwapTable& table, const std::vector<std::size_t>& start,
                               const std::vector<bool>& allowed, std::size_t count,
                               const base::Control& control);

/// Remove columns until a choice has at most `most` different ones. Each time, the column goes whose loss
/// worsens the sweep least. Returns for each column whether it is left.
std::vector<bool> fewer_columns(const SwapTable& table, const std::vector<std::size_t>& start,
                                SweepOptions options, std::size_t most);

}  // namespace fretwork::design::detail
