// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork solve: any beam structure, from a frame file.
#include "file_options.hpp"
#include "solve_output.hpp"
#include "verbs.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/file.hpp>
#include <fretwork/exports/line_files.hpp>
#include <fretwork/mechanics/calculix_file.hpp>
#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/mechanics/equilibrium.hpp>
#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/relaxation.hpp>
#include <fretwork/mechanics/result_file.hpp>

#include <chrono>
#include <cstdio>
#include <memory>
#include <utility>

namespace fretwork::app {
namespace {

constexpr const char* kExample = R"(
Examples:
  fretwork solve frame.json --out result.json                   nonlinear, to the full load
  fretwork solve frame.json --solver linear --out result.json
  fretwork solve frame.json --steps 20 --out result.json        with the 20 equilibria on the way
  fretwork solve frame.json --estimate-error --out result.json  and how far it is from endlessly fine divisions
  fretwork solve frame.json --branch stable --out result.json   past a bifurcation, as a specimen would go
  fretwork solve frame.json --solver linear --buckling 3 --out result.json
  fretwork solve frame.json --solver linear --modes 6 --out result.json --vtu result.vtu)";

/// Equilibria on the way to the full load where none are asked for: enough that the path is followed and not
/// jumped from.
constexpr int kDefaultSteps = 10;

struct Wishes {
    std::string frame;
    std::string solver = "newton";
    std::string out;
    std::string vtu;
    std::string deck;
    int steps = 0;
    int modes = 0;
    int buckling = 0;
    int threads = 0;
    std::string branch = "primary";
    std::string masses = "natural";
    bool lumped_gravity = false;
    bool estimate_error = false;
    bool json = false;
};

mechanics::EquilibriumOptions path_options(const Wishes& wishes) {
    mechanics::EquilibriumOptions options;
    options.locate_critical_loads = true;
    options.threads = wishes.threads;
    if (wishes.branch == "stable") options.branch = mechanics::Branch::Stable;
    return options;
}

std::vector<double> load_factors(const Wishes& wishes) {
    return mechanics::even_load_factors(wishes.steps > 0 ? wishes.steps : kDefaultSteps);
}

/// The end of a path, with what was met on all of it.
mechanics::Solution end_of(const std::vector<mechanics::Solution>& steps) {
    mechanics::Solution end = steps.back();
    end.iterations = 0;
    end.stability_losses.clear();
    for (const mechanics::Solution& step : steps) {
        end.iterations += step.iterations;
        end.stability_losses.insert(end.stability_losses.end(), step.stability_losses.begin(),
                                    step.stability_losses.end());
    }
    return end;
}

/// A frame file, or a CalculiX or Abaqus deck, whose nodes keep their labels.
mechanics::LabelledFrame read(const std::string& path) {
    if (path.ends_with(".inp")) return mechanics::read_calculix(path);
    mechanics::LabelledFrame named{mechanics::read_frame(path), {}};
    for (std::size_t i = 0; i < named.frame.nodes.size(); ++i) named.labels.push_back(static_cast<int>(i));
    return named;
}

struct Solved {
    mechanics::Assembly assembly;
    mechanics::Result result;
};

Solved solve(const mechanics::LabelledFrame& input, const Wishes& wishes) {
    const mechanics::Frame& frame = input.frame;
    mechanics::Result result;
    result.solver = wishes.solver;
    for (std::size_t i = 0; i < frame.nodes.size(); ++i)
        result.nodes.push_back({input.labels[i], frame.nodes[i], false});
    const auto start = std::chrono::steady_clock::now();
    mechanics::Assembly assembly = mechanics::assemble(frame, {wishes.lumped_gravity, input.labels});
    if (wishes.solver == "linear") {
        result.solution = mechanics::solve_linear(assembly, {.threads = wishes.threads});
    } else if (wishes.solver == "dynamic-relaxation") {
        const bool published = wishes.masses == "published";
        result.solution =
            mechanics::relax(assembly, {.rotational_mass = published ? mechanics::RotationalMass::Published
                                                                     : mechanics::RotationalMass::Natural});
    } else {
        auto steps = mechanics::follow_load_path(assembly, load_factors(wishes), path_options(wishes));
        result.solution = end_of(steps);
        result.load_steps = std::move(steps);
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (wishes.estimate_error)
        result.discretization_error =
            mechanics::estimate_discretization_error(frame, load_factors(wishes), result.load_steps,
                                                     path_options(wishes))
                .back();
    if (wishes.steps == 0) result.load_steps.clear();
    if (wishes.modes > 0) result.vibration_modes = mechanics::vibration_modes(assembly, wishes.modes);
    if (wishes.buckling > 0) result.buckling_modes = mechanics::buckling_modes(assembly, wishes.buckling);
    return {std::move(assembly), std::move(result)};
}

/// What a solver finds is said with the file.
Solved solve_file(const mechanics::LabelledFrame& input, const Wishes& wishes) {
    try {
        return solve(input, wishes);
    } catch (const base::NumericalError& error) {
        throw base::NumericalError(wishes.frame + ": " + error.what());
    }
}

/// Options that one solver alone looks at: with another they are a misunderstanding.
void refuse_ignored_options(const CLI::App& verb, const std::string& solver) {
    if (verb.count("--threads") > 0 && solver == "dynamic-relaxation")
        throw base::InputError("--threads: dynamic-relaxation works on one thread");
    constexpr std::pair<const char*, const char*> kOwnOptions[] = {{"--steps", "newton"},
                                                                   {"--branch", "newton"},
                                                                   {"--estimate-error", "newton"},
                                                                   {"--masses", "dynamic-relaxation"}};
    for (const auto& [option, owner] : kOwnOptions) {
        if (verb.count(option) > 0 && solver != owner)
            throw base::InputError(std::string(option) + " works with --solver " + owner + ", not with " +
                                   solver);
    }
}

ExitCode run(const Wishes& wishes) {
    const mechanics::LabelledFrame input = read(wishes.frame);
    const auto [assembly, result] = solve_file(input, wishes);
    base::FileBatch files;
    files.add(wishes.out, mechanics::result_text(result));
    if (!wishes.deck.empty()) files.add(wishes.deck, mechanics::calculix_text(input.frame));
    if (!wishes.vtu.empty())
        files.add(wishes.vtu, exports::vtu_text(exports::solution_lines(assembly, result)));
    files.commit();
    if (wishes.json) {
        print_solution_json(result);
    } else {
        print_solution(result);
        if (std::ssize(result.buckling_modes) < wishes.buckling)
            std::printf("no more than %zd buckling loads: the others, if any, are of reversed loads\n",
                        std::ssize(result.buckling_modes));
        if (wishes.buckling > 0 && assembly.has_moments)
            std::printf("buckling loads take moments of fixed direction for semi-tangential ones\n");
        std::printf("wrote %s\n", wishes.out.c_str());
        if (!wishes.vtu.empty()) std::printf("wrote %s\n", wishes.vtu.c_str());
    }
    return result.solution.converged() ? ExitCode::Done : ExitCode::DidNotSucceed;
}

}  // namespace

void add_solve(CLI::App& app, ExitCode& exit_code) {
    auto wishes = std::make_shared<Wishes>();
    CLI::App* verb = app.add_subcommand("solve", "Solve any beam structure from a frame file.");
    verb->footer(kExample);
    verb->add_option("frame", wishes->frame, "frame file, or the beams of a CalculiX or Abaqus deck (.inp)")
        ->required();
    verb->add_option("--solver", wishes->solver,
                     "linear; or, for large displacements and rotations, newton or dynamic-relaxation")
        ->check(CLI::IsMember({"linear", "newton", "dynamic-relaxation"}))
        ->capture_default_str();
    verb->add_option("--steps", wishes->steps, "reach the load in so many steps, and write each of them")
        ->check(CLI::Range(1, 100000));
    verb->add_option(
            "--branch", wishes->branch,
            "where the path becomes unstable: primary goes on along it, stable is pushed off it along the "
            "critical mode (newton only)")
        ->check(CLI::IsMember({"primary", "stable"}))
        ->capture_default_str();
    verb->add_option(
            "--masses", wishes->masses,
            "rotational masses of dynamic-relaxation: natural, or those of published programs, which are "
            "slower")
        ->check(CLI::IsMember({"natural", "published"}))
        ->capture_default_str();
    CLI::Option* lumped = verb->add_flag("--lumped-gravity", wishes->lumped_gravity,
                                         "half of a beam's weight on each end, no moments");
    verb->add_flag("--estimate-error", wishes->estimate_error,
                   "tell how far the solution is from that of endlessly fine divisions (newton only: linear "
                   "solutions of straight beams are exact at the nodes)")
        ->excludes(lumped);
    verb->add_option("--buckling", wishes->buckling, "so many critical load factors by linearized buckling")
        ->check(CLI::Range(1, 1000));
    verb->add_option("--modes", wishes->modes,
                     "so many natural frequencies and modes of the structure at rest")
        ->check(CLI::Range(1, 1000));
    verb->add_option("--threads", wishes->threads,
                     "Threads to use; 0: all there are (linear and newton; the result is the same)")
        ->check(thread_check())
        ->capture_default_str();
    verb->add_option("--vtu", wishes->vtu, "the displaced beams, and modes, for ParaView");
    verb->add_option("--deck", wishes->deck, "write the frame as an input deck for Abaqus (.inp)");
    verb->add_option("--out", wishes->out, "result file")->required();
    verb->add_flag("--json", wishes->json, "print a summary for programs");
    declare_files(*verb, {input("frame"), output("--out", kResultFile), output("--vtu", kVtuFile),
                          output("--deck", kDeckFile)});
    verb->callback([wishes, verb, &exit_code] {
        refuse_ignored_options(*verb, wishes->solver);
        exit_code = run(*wishes);
    });
}

}  // namespace fretwork::app
