// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork compare: how far a reduced result is from the full one.
#include "options/checks.hpp"
#include "options/file_options.hpp"
#include "output.hpp"
#include "surface_result.hpp"
#include "verbs.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/results/comparison.hpp>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

namespace fretwork::app {
namespace {

struct CompareOptions {
    std::string full;
    std::string reduced;
    std::string name;
    std::optional<double> tolerance;
    bool csv = false;
    bool json = false;
};

base::Json to_json(const std::string& name, const simulation::Comparison& comparison) {
    return {{"example", name},
            {"width_m", comparison.width},
            {"height_m", comparison.height},
            {"max_displacement_m", comparison.max_displacement},
            {"max_translation_error_m", comparison.max_translation_error},
            {"mean_translation_error_m", comparison.mean_translation_error},
            {"sd_translation_error", comparison.sd_translation_error},
            {"max_rotation_rad", comparison.max_rotation},
            {"max_rotation_error_rad", comparison.max_rotation_error},
            {"mean_rotation_error_rad", comparison.mean_rotation_error},
            {"sd_rotation_error", comparison.sd_rotation_error},
            {"relative_l2_error", comparison.relative_l2_error},
            {"full_model_seconds", comparison.full_seconds},
            {"reduced_model_seconds", comparison.reduced_seconds},
            {"full_is_unstable", comparison.full_is_unstable},
            {"joints", base::or_null(comparison.joints, reduction::joints_name)}};
}

/// A refusal names the files, which the stage does not know.
simulation::Comparison compare(const CompareOptions& options, const simulation::SurfaceResult& full,
                               const simulation::SurfaceResult& reduced) {
    return base::located(options.full + " and " + options.reduced, "",
                         [&] { return simulation::compare(full, reduced); });
}

ExitCode run(const CompareOptions& options) {
    const auto results = read_surface_results(std::array{options.full, options.reduced});
    const simulation::SurfaceResult& full = results.front();
    const simulation::SurfaceResult& reduced = results.back();
    const simulation::Comparison comparison = compare(options, full, reduced);
    const std::string name =
        options.name.empty() ? std::filesystem::path(options.full).stem().string() : options.name;
    if (options.json) {
        print_document(to_json(name, comparison));
    } else if (!options.csv) {
        std::printf("%s: %s", base::printable(name).c_str(), simulation::comparison_text(comparison).c_str());
    } else {
        std::printf("%s\n%s\n", simulation::comparison_header().c_str(),
                    simulation::comparison_row(base::printable(name), comparison).c_str());
    }
    if (comparison.full_is_unstable)
        warn(options.full +
             ": the errors are relative to an equilibrium that is not stable; simulate --branch stable finds "
             "the stable one");
    if (options.tolerance && !(comparison.relative_l2_error <= *options.tolerance)) {
        warn("the relative error " + base::format_number(comparison.relative_l2_error, 4) +
             " is above the tolerance " + base::format_number(*options.tolerance, 4));
        return ExitCode::DidNotSucceed;
    }
    return ExitCode::Done;
}

}  // namespace

void add_compare(CLI::App& app, ExitCode& exit_code) {
    CLI::App* verb = app.add_subcommand("compare", "Compare a reduced model's result with the full model's");
    const auto options = std::make_shared<CompareOptions>();
    verb->add_option("full", options->full, "Result of the full model")->required();
    verb->add_option("reduced", options->reduced, "Result of a reduced model of the same project")
        ->required();
    verb->add_option("--name", options->name, "Name of the comparison (default: the first file's name)");
    verb->add_option("--tolerance", options->tolerance,
                     "Exit with 1 if the relative L2 error of the translations is above this")
        ->check(not_negative_check());
    CLI::Option* csv =
        verb->add_flag("--csv", options->csv, "Print a header and a row of Table 3, in metres");
    verb->add_flag("--json", options->json, "Print JSON")->excludes(csv);
    declare_files(*verb, {input("full"), input("reduced")});
    verb->footer(
        "Example: fretwork compare full.json reduced.json\n"
        "         fretwork compare full.json reduced.json --csv");
    verb->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace fretwork::app
