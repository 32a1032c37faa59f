// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork solve: any beam structure, from a frame file.
#include "interrupt.hpp"
#include "options/checks.hpp"
#include "options/file_options.hpp"
#include "verbs.hpp"
#include "verbs/solve_output.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/exports/tables/line_files.hpp>
#include <fretwork/mechanics/decks/calculix_file.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/solve.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

namespace fretwork::app {
namespace {

constexpr const char* kSolveExample = R"(
Examples:
  fretwork solve frame.json --out result.json                   nonlinear, to the full load
  fretwork solve frame.json --solver linear --out result.json
  fretwork solve frame.json --steps 20 --out result.json        with the 20 equilibria on the way
  fretwork solve frame.json --estimate-error --out result.json  with an estimate of its discretization error
  fretwork solve frame.json --branch stable --out result.json   past a bifurcation, as a specimen would move
  fretwork solve frame.json --solver linear --buckling 3 --out result.json
  fretwork solve frame.json --solver linear --modes 6 --out result.json --vtu result.vtu)";

struct SolveOptions {
    std::string frame;
    std::string solver = "newton";
    std::string out;
    std::string vtu;
    std::string deck;
    std::string deck_for = "abaqus";
    std::optional<std::string> branch;
    std::optional<std::string> masses;
    mechanics::SolveOptions solve;
    bool json = false;
};

mechanics::SolveOptions solve_options(const SolveOptions& options) {
    mechanics::SolveOptions solve = options.solve;
    solve.solver = mechanics::find_solver(options.solver);
    if (options.branch) solve.branch = mechanics::find_branch(*options.branch);
    if (options.masses)
        solve.rotational_mass = *options.masses == "published" ? mechanics::RotationalMass::Published
                                                               : mechanics::RotationalMass::Natural;
    return solve;
}

void print_note_on_moments(const mechanics::Frame& frame, const SolveOptions& options) {
    const bool has_moments = std::ranges::any_of(
        frame.loads, [](const mechanics::NodalLoad& load) { return !load.moment.isZero(0.0); });
    if (options.solve.buckling_modes > 0 && has_moments)
        std::printf("buckling loads take moments of fixed direction for semi-tangential ones\n");
}

/// Errors of what a deck cannot hold name the frame's file.
std::string deck_text(const mechanics::Frame& frame, const SolveOptions& options) {
    const auto program =
        options.deck_for == "calculix" ? mechanics::DeckProgram::Calculix : mechanics::DeckProgram::Abaqus;
    return base::located(options.frame, "", [&] { return mechanics::calculix_text(frame, program); });
}

ExitCode run(const SolveOptions& options) {
    LongWork work;
    mechanics::SolveOptions solve = solve_options(options);
    solve.control = work.control();
    solve.validate();
    const mechanics::LabelledFrame input = mechanics::read_structure(options.frame);
    // The deck comes before the solution, which would be lost if no deck can hold the frame.
    const std::string deck = options.deck.empty() ? "" : deck_text(input.frame, options);
    const mechanics::Result result = mechanics::solve(input, solve);
    base::FileBatch files;
    files.add(options.out, mechanics::result_text(result));
    if (!options.deck.empty()) files.add(options.deck, deck);
    if (!options.vtu.empty())
        files.add(options.vtu,
                  exports::vtu_text(exports::solution_lines(mechanics::assemble(input.frame), result)));
    files.commit();
    if (options.json) {
        print_solution_json(result);
    } else {
        print_solution(result, {solve.vibration_modes, solve.buckling_modes,
                                solve.branch.value_or(mechanics::Branch::Primary)});
        print_note_on_moments(input.frame, options);
        std::printf("wrote %s\n", options.out.c_str());
        if (!options.vtu.empty()) std::printf("wrote %s\n", options.vtu.c_str());
    }
    return result.solution.converged() ? ExitCode::Done : ExitCode::DidNotSucceed;
}

void add_method(CLI::App& verb, SolveOptions& options) {
    verb.add_option("--solver", options.solver,
                    "Method: linear; or, for large displacements and rotations, newton or dynamic-relaxation")
        ->check(CLI::IsMember({"linear", "newton", "dynamic-relaxation"}))
        ->capture_default_str();
    verb.add_option("--steps", options.solve.steps, "Number of equal load steps; each is written")
        ->check(CLI::Range(1, 100000));
    verb.add_option("--branch", options.branch,
                    "Path to follow after a loss of stability (newton only). primary: the same path, stable "
                    "or not. stable: the stable path that branches off. snapping: as stable; at a limit "
                    "load, the structure jumps to a stable equilibrium of lower energy (default: primary)")
        ->check(CLI::IsMember(mechanics::branch_names()));
    verb.add_option(
            "--masses", options.masses,
            "Rotational masses of dynamic-relaxation: natural, or those of published programs, which are "
            "slower (default: natural)")
        ->check(CLI::IsMember({"natural", "published"}));
    verb.add_option(
            "--threads", options.solve.threads,
            "Threads to use; 0: one for each processor (linear and newton; the result does not depend "
            "on it)")
        ->check(thread_check());
}

/// Adds --lumped-gravity, and the options for what else to compute.
void add_questions(CLI::App& verb, SolveOptions& options) {
    CLI::Option* lumped = verb.add_flag("--lumped-gravity", options.solve.lumped_gravity,
                                        "Put half of a beam's weight on each end, without moments");
    verb.add_flag("--estimate-error", options.solve.estimate_error,
                  "Estimate the discretization error: the distance from the limit of ever finer divisions of "
                  "the beams (newton only: linear solutions of straight beams are exact at the nodes)")
        ->excludes(lumped);
    verb.add_option("--buckling", options.solve.buckling_modes,
                    "Number of critical load factors by linearized buckling")
        ->check(CLI::Range(1, mechanics::kMostModes));
    verb.add_option("--modes", options.solve.vibration_modes,
                    "Number of natural frequencies and modes of the structure at rest")
        ->check(CLI::Range(1, mechanics::kMostModes));
}

}  // namespace

void add_solve(CLI::App& app, ExitCode& exit_code) {
    auto options = std::make_shared<SolveOptions>();
    CLI::App* verb = app.add_subcommand("solve", "Solve any beam structure from a frame file.");
    verb->footer(kSolveExample);
    verb->add_option("frame", options->frame, "Frame file, or the beams of a CalculiX or Abaqus deck (.inp)")
        ->required();
    add_method(*verb, *options);
    add_questions(*verb, *options);
    verb->add_option("--vtu", options->vtu, "Write the displaced beams, and modes, for ParaView");
    verb->add_option("--deck", options->deck, "Write the frame as an input deck (.inp)");
    verb->add_option(
            "--deck-for", options->deck_for,
            "Program that is to read --deck: abaqus (beams), or calculix (ccx makes solids of them). "
            "In ccx, rectangular bars are up to a fifth stiffer in torsion, so displacements, forces "
            "and moments can differ by a tenth and more")
        ->check(CLI::IsMember({"abaqus", "calculix"}))
        ->capture_default_str();
    verb->add_option("--out", options->out, "Result file")->required();
    verb->add_flag("--json", options->json, "Print a summary as JSON");
    declare_files(*verb, {input("frame"), output("--out", kResultFile), output("--vtu", kVtuFile),
                          output("--deck", kDeckFile)});
    verb->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace fretwork::app
