// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/base/stopwatch.hpp>
#include <fretwork/mechanics/decks/calculix_file.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>
#include <fretwork/mechanics/internal/mode_count.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/solve.hpp>

#include <numeric>
#include <string>
#include <utility>

namespace fretwork::mechanics {
namespace {

/// The number of equilibria on the way to the full load if the options give no number. It is enough to follow
/// the path without a jump.
constexpr int kDefaultSteps = 10;

using NamedSolver = std::pair<Solver, std::string_view>;
constexpr NamedSolver kSolvers[] = {{Solver::Linear, "linear"},
                                    {Solver::Newton, "newton"},
                                    {Solver::DynamicRelaxation, "dynamic-relaxation"}};

EquilibriumOptions path_options(const SolveOptions& options) {
    EquilibriumOptions path;
    path.branch = options.branch.value_or(Branch::Primary);
    path.locate_critical_loads = options.locate_critical_loads;
    path.threads = options.threads.value_or(0);
    path.control = options.control;
    return path;
}

std::vector<double> load_factors(const SolveOptions& options) {
    return even_load_factors(options.steps.value_or(kDefaultSteps));
}

/// The solutions of the path, or the only solution.
std::vector<Solution> equilibria(const Assembly& assembly, const SolveOptions& options) {
    switch (options.solver) {
        case Solver::Linear:
            return {
                solve_linear(assembly, {.threads = options.threads.value_or(0), .control = options.control})};
        case Solver::Newton:
            return follow_load_path(assembly, load_factors(options), path_options(options));
        case Solver::DynamicRelaxation:
            break;
    }
    RelaxationOptions relaxation;
    relaxation.rotational_mass = options.rotational_mass.value_or(RotationalMass::Natural);
    relaxation.control = options.control;
    return {relax(assembly, relaxation)};
}

std::vector<Result::Node> reported_nodes(const Assembly& assembly) {
    std::vector<Result::Node> nodes;
    for (int i = 0; i < assembly.reported_nodes; ++i) {
        const std::size_t place = i;
        nodes.push_back({assembly.labels.empty() ? i : assembly.labels[place], assembly.nodes[place], false});
    }
    return nodes;
}

void add_modes(const Assembly& assembly, const SolveOptions& options, Result& result) {
    const ModeOptions modes{.control = options.control};
    if (options.vibration_modes > 0)
        result.vibration_modes = vibration_modes(assembly, options.vibration_modes, modes);
    if (options.buckling_modes > 0)
        result.buckling_modes = buckling_modes(assembly, options.buckling_modes, modes);
}

/// The modes and all solutions of an assembly. The modes come first, because they do not need the solutions:
/// modes that cannot be found shall not cost a path that took minutes.
Result result_of(const Assembly& assembly, const SolveOptions& options) {
    Result result;
    add_modes(assembly, options, result);
    const base::Stopwatch watch;
    result.solver = solver_name(options.solver);
    result.nodes = reported_nodes(assembly);
    result.load_steps = equilibria(assembly, options);
    for (const Solution& solution : result.load_steps) require_sensible_motion(solution);
    result.solution = end_of_path(result.load_steps);
    result.seconds = watch.seconds();
    return result;
}

Assembly assembled(const LabelledFrame& input, const SolveOptions& options) {
    return assemble(input.frame, {options.lumped_gravity, input.labels, options.control.silent()});
}

Result solve_frame(const LabelledFrame& input, const SolveOptions& options) {
    const base::Stopwatch watch;
    const Assembly assembly = assembled(input, options);
    const double assembling = watch.seconds();
    Result result = result_of(assembly, options);
    result.seconds += assembling;
    if (options.estimate_error)
        result.discretization_error = estimate_discretization_error(input.frame, load_factors(options),
                                                                    result.load_steps, path_options(options))
                                          .back();
    if (!options.steps) result.load_steps.clear();
    return result;
}

void require(bool good, const std::string& message) {
    if (!good) throw base::InputError(message);
}

}  // namespace

std::string_view solver_name(Solver solver) {
    for (const auto& [known, name] : kSolvers) {
        if (known == solver) return name;
    }
    return "";
}

std::vector<std::string_view> solver_names() {
    std::vector<std::string_view> names;
    for (const auto& [known, name] : kSolvers) names.push_back(name);
    return names;
}

Solver find_solver(std::string_view name) {
    return base::find_named(name, kSolvers, &NamedSolver::second, "solver").first;
}

void SolveOptions::validate() const {
    const auto only_with = [&](bool is_given, const char* option, Solver owner) {
        require(!is_given || solver == owner, std::string(option) + " works with the solver " +
                                                  std::string(solver_name(owner)) + ", not with " +
                                                  std::string(solver_name(solver)));
    };
    only_with(steps.has_value(), "steps", Solver::Newton);
    only_with(branch.has_value(), "branch", Solver::Newton);
    only_with(estimate_error, "estimate-error", Solver::Newton);
    only_with(rotational_mass.has_value(), "masses", Solver::DynamicRelaxation);
    require(!threads || solver != Solver::DynamicRelaxation,
            "threads: dynamic-relaxation works on one thread");
    require(!estimate_error || branch != Branch::Snapping,
            "estimate-error works along the primary and the stable branch, not beyond limit loads");
    require(!estimate_error || !lumped_gravity,
            "estimate-error works with consistent gravity, not with lumped-gravity");
    require(steps.value_or(1) >= 1,
            "steps is " + std::to_string(steps.value_or(1)) + ", and must be above zero");
    require(threads.value_or(0) >= 0,
            "threads is " + std::to_string(threads.value_or(0)) + ", and must not be negative");
    for (const int modes : {vibration_modes, buckling_modes}) check_mode_count(modes, 0);
}

LabelledFrame read_structure(const std::filesystem::path& path) {
    if (base::ending_of(path) == ".inp") return read_calculix(path);
    LabelledFrame input{read_frame(path), {}, path.string()};
    input.labels.resize(input.frame.nodes.size());
    std::iota(input.labels.begin(), input.labels.end(), 0);
    return input;
}

Result solve(const Assembly& assembly, const SolveOptions& options) {
    options.validate();
    require(!options.estimate_error, "a discretization error is estimated for a frame only");
    require(!options.lumped_gravity, "lumped-gravity is for a frame: an assembly has its loads");
    Result result = result_of(assembly, options);
    if (!options.steps) result.load_steps.clear();
    return result;
}

Result solve(const LabelledFrame& frame, const SolveOptions& options) {
    options.validate();
    try {
        return solve_frame(frame, options);
    } catch (const base::NumericalError& error) {  // names the frame's file
        if (frame.source.empty()) throw;
        throw base::within(frame.source, "", error);
    }
}

}  // namespace fretwork::mechanics
