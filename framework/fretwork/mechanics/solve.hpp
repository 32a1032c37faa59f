// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/mechanics/paths/relaxation.hpp>
#include <fretwork/mechanics/results/result_file.hpp>

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace fretwork::mechanics {

/// The solvers that find an equilibrium.
enum class Solver {
    Linear,            ///< small displacements: LinearSolver
    Newton,            ///< large displacements: follow_load_path
    DynamicRelaxation  ///< large displacements by the paper's method: relax
};
/// The name of a solver: "linear", "newton" or "dynamic-relaxation".
std::string_view solver_name(Solver solver);
/// The names of the solvers, as people type them.
std::vector<std::string_view> solver_names();
/// The solver with this name. Throws InputError that lists the names.
Solver find_solver(std::string_view name);

/// Options of solve(). An option that only some solvers have is std::optional, and it is an error to set it
/// for another solver.
struct SolveOptions {
    Solver solver = Solver::Newton;  ///< which solver
    /// Newton: the number of equal load steps; the solution of each is kept. None: ten steps, and only the
    /// last solution is kept.
    std::optional<int> steps{};
    std::optional<Branch> branch{};                   ///< Newton; none: primary
    std::optional<RotationalMass> rotational_mass{};  ///< dynamic relaxation; none: natural
    std::optional<int> threads{};                     ///< linear and Newton; none or 0: one for each
                                                      ///< processor
    bool locate_critical_loads = true;                ///< Newton; costs a few more equilibria at each
                                                      ///< critical load
    bool estimate_error =
        false;  ///< Newton, for a frame with consistent gravity: estimate the discretization error
    bool lumped_gravity = false;  ///< see AssemblyOptions
    int vibration_modes = 0;      ///< number of natural frequencies of the structure at rest
    int buckling_modes = 0;       ///< number of critical load factors by linearized buckling
    base::Control control{};      ///< how the caller follows and stops the work
    /// Throws InputError if a value is invalid, or the solver would ignore it.
    void validate() const;
};

/// Read a structure: a deck if the name ends in .inp, else a frame file. Nodes of a frame file get their
/// indices, from 0, as labels.
LabelledFrame read_structure(const std::filesystem::path& path);

/// Solve a structure. Result::seconds is the time from the elements to the solution, without modes. Throws as
/// the solvers do. Throws InputError if the options ask for a discretization error, which can be estimated
/// only for a frame.
Result solve(const Assembly& assembly, const SolveOptions& options = {});
/// Assemble and solve a frame, on request with an estimate of its discretization error. Result::seconds
/// includes the assembly. Numerical errors name the frame's source.
Result solve(const LabelledFrame& frame, const SolveOptions& options = {});

}  // namespace fretwork::mechanics
