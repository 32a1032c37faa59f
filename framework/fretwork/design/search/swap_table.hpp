// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace fretwork::design::detail {

/// What every swap does to the residuals of all load cases, to first order in their superposition. *Groups*
/// of tiles are painted together; a *choice* is a column of the table for each group.
struct SwapTable {
    Eigen::VectorXd residual;  ///< rho, k numbers
    double unreached = 0.0;    ///< what no choice changes of the sum of squares
    std::vector<Eigen::MatrixXd>
        responses;                  ///< of each group: k rows, a column for each pattern of the table
    Eigen::MatrixXd energies;       ///< f . G f, columns x groups, J
    Eigen::MatrixXd masses;         ///< kg, columns x groups
    Eigen::MatrixXd by_factors;     ///< k rows; a column for each continuous unknown
    Eigen::VectorXd largest_steps;  ///< of the unknowns
    double energy = 0.0;            ///< of the surface, J

    [[nodiscard]] std::size_t groups() const { return responses.size(); }
    [[nodiscard]] std::size_t columns() const { return static_cast<std::size_t>(energies.rows()); }
};

/// What is chosen for each group, and steps of the continuous unknowns.
struct Choice {
    std::vector<std::size_t> columns;
    Eigen::VectorXd steps;
    double objective = 0.0;  ///< predicted: the sum of squares
    double energy = 0.0;     ///< of the change, J
};

struct SweepOptions {
    std::vector<bool> allowed;  ///< columns
    double radius = 0.5;        ///< the energy of the change is at most this share of the surface's
    double most_mass = 0.0;     ///< kg, of all groups; 0: any
    std::uint64_t seed = 1;
    int orders = 3;  ///< random orders of the groups that are tried
    base::Control control{};
};

/// Integer least squares by sweeps: each group in turn takes the column that is best with all the others as
/// they are, and the continuous unknowns take theirs; in several random orders, with a price on the energy of
/// the change that keeps it within the radius. The best of what was found. Throws Stopped.
Choice sweep(const SwapTable& table, const std::vector<std::size_t>& start, const SweepOptions& options);

/// Leave so few columns that a choice has at most `most` different ones, of which `kept` are: again and again
/// the column is given up without which the sweep is least worse.
std::vector<bool> fewer_columns(const SwapTable& table, const std::vector<std::size_t>& start,
                                SweepOptions options, std::size_t most);

}  // namespace fretwork::design::detail
