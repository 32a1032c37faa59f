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

/// Ways to an equilibrium.
enum class Solver {
    Linear,            ///< small displacements: LinearSolver
    Newton,            ///< large ones: follow_load_path
    DynamicRelaxation  ///< the same, as the paper finds them: relax
};
/// "linear", "newton", "dynamic-relaxation"
std::string_view solver_name(Solver solver);
std::vector<std::string_view> solver_names();
/// Throws InputError that lists the names.
Solver find_solver(std::string_view name);

/// How to solve a structure. Options of one solver alone are optional, and refused where another one would
/// ignore them.
struct SolveOptions {
    Solver solver = Solver::Newton;
    /// Newton: reach the load in this many equal steps, and keep the solution of each. None: in ten, of which
    /// only the last is kept.
    std::optional<int> steps{};
    std::optional<Branch> branch{};                   ///< Newton; none: primary
    std::optional<RotationalMass> rotational_mass{};  ///< dynamic relaxation; none: natural
    std::optional<int> threads{};                     ///< linear and Newton; none or 0: all there are
    bool locate_critical_loads = true;                ///< Newton; costs a few equilibria where one is passed
    bool estimate_error =
        false;  ///< Newton, of a frame with consistent gravity: that of the beams' divisions
    bool lumped_gravity = false;  ///< as AssemblyOptions
    int vibration_modes = 0;      ///< number of natural frequencies of the structure at rest
    int buckling_modes = 0;       ///< number of critical load factors by linearized buckling
    base::Control control{};
    /// Throws InputError if a value is invalid, or the solver would ignore it.
    void validate() const;
};

/// Read a structure: a frame file, or a deck if its name ends in .inp. Nodes without labels are labelled by
/// their places, from 0.
LabelledFrame read_structure(const std::filesystem::path& path);

/// Solve a structure. Result::seconds is the time from the elements to the solution, without modes. Throws as
/// the solvers do; InputError if a discretization error is wanted, which only a frame has.
Result solve(const Assembly& assembly, const SolveOptions& options = {});
/// The same from a frame: assembled, with the time for that in Result::seconds, and, on request, with an
/// estimate of its discretization error. Numerical errors name the frame's source.
Result solve(const LabelledFrame& frame, const SolveOptions& options = {});

}  // namespace fretwork::mechanics
