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
    Linear,            ///< small displacements: solve_linear
    Newton,            ///< large displacements: follow_load_path
    DynamicRelaxation  ///< large displacements by the paper's method: relax
};
/// The name of a solver: "linear", "newton" or "dynamic-relaxation".
std::string_view solver_name(Solver solver);
/// The names of all solvers.
std::vector<std::string_view> solver_names();
/// The solver with this name. Throws InputError that suggests the nearest name or lists all names.
Solver find_solver(std::string_view name);

/// Options of solve(). Options of only some solvers are std::optional, except for estimate_error and
/// locate_critical_loads. It is an error to set one for another solver; only locate_critical_loads is ignored
/// then.
struct SolveOptions {
    Solver solver = Solver::Newton;  ///< the solver
    /// The number of equal load steps, for Newton; the solution of each step is kept. None: ten steps, and
    /// only the last solution is kept.
    std::optional<int> steps{};
    /// Equilibria to follow after a loss of stability, for Newton; none: Branch::Primary.
    std::optional<Branch> branch{};
    /// Fictitious masses of rotations, for dynamic relaxation; none: RotationalMass::Natural.
    std::optional<RotationalMass> rotational_mass{};
    /// Number of threads, for linear and Newton; none or 0: one for each processor.
    std::optional<int> threads{};
    /// True: locate critical loads, for Newton. Each critical load then costs a few more equilibria.
    bool locate_critical_loads = true;
    /// True: estimate the discretization error. This needs Newton, a frame with consistent gravity, and a
    /// branch other than Branch::Snapping.
    bool estimate_error = false;
    bool lumped_gravity = false;  ///< true: lumped gravity; see AssemblyOptions
    int vibration_modes = 0;      ///< number of natural frequencies of the structure at rest
    int buckling_modes = 0;       ///< number of critical load factors by linearized buckling
    base::Control control{};      ///< progress and stop
    /// Throws InputError if a value is invalid, if options exclude each other, or if an option other than
    /// locate_critical_loads is set for a solver that ignores it.
    void validate() const;
};

/// Read a structure from a deck (a file with the ending .inp, in small or capital letters) or from a frame
/// file. The labels of a frame file's nodes are their indices, from 0. Throws as read_calculix() and
/// read_frame().
LabelledFrame read_structure(const std::filesystem::path& path);

/// Solve an assembly. Result::seconds is the time of the solution, without modes. Throws the errors of
/// SolveOptions::validate(), of the solver, of require_sensible_motion() and of the modes. Throws InputError
/// if the options ask for the discretization error or for lumped gravity: both need a frame.
Result solve(const Assembly& assembly, const SolveOptions& options = {});
/// Assemble and solve a frame. The discretization error is estimated if the options ask for it.
/// Result::seconds includes the assembly, but neither the estimate nor the modes. Throws the errors of
/// SolveOptions::validate(), assemble(), and those of solving an assembly. A NumericalError names the frame's
/// source.
Result solve(const LabelledFrame& frame, const SolveOptions& options = {});

}  // namespace fretwork::mechanics
