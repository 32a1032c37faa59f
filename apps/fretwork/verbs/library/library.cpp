// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork library: look into a pattern library, find patterns, merge shards, write tables and meshes.
#include "interrupt.hpp"
#include "options/file_options.hpp"
#include "options/pattern_choice.hpp"
#include "output.hpp"
#include "verbs.hpp"
#include "verbs/library/library_find.hpp"
#include "verbs/library/library_show.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/drawings/pattern_drawing.hpp>
#include <fretwork/exports/drawings/property_chart.hpp>
#include <fretwork/exports/tables/library_meshes.hpp>
#include <fretwork/exports/tables/library_stiffness.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/library/merge.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace fretwork::app {
namespace {

using base::Json;
using library::Library;
using library::PatternSummary;

constexpr const char* kExamples = R"(
Examples:
  fretwork library list --library lib.db
  fretwork library find --library lib.db --where "bending_poisson < 0" --sort mass_per_area --limit 10
  fretwork library show 0-1+1-6 --library lib.db --json
  fretwork library merge all.db shard1.db shard2.db
  fretwork library export --library lib.db --csv tables --meshes meshes --chart chart.svg)";

/// The files of `export --csv`.
constexpr const char* kTables =
    "behaviour.csv calibration.csv calibration_error.csv calibration_parameter.csv failure.csv pattern.csv "
    "property.csv response.csv response_state.csv scenario.csv layout.json setting.json";

struct LibraryOptions {
    std::string library;
    std::string pattern;
    std::string output;
    std::vector<std::filesystem::path> inputs;
    std::string csv;
    std::string meshes;
    std::string stiffness;
    std::string svg;
    std::string scenarios;
    std::string chart;
    std::string patterns = "all";
    library::PatternQuery query;
    bool ply = false;
    bool json = false;
};

Library open_library(const LibraryOptions& options) {
    if (options.library.empty()) throw base::InputError("--library", "", "is needed: the library's file");
    return Library::open(options.library);
}

// ---- list ----

Json list_json(const Library& library, const std::vector<PatternSummary>& summaries) {
    Json patterns = Json::array();
    for (const PatternSummary& summary : summaries) {
        patterns.push_back({{"id", summary.pattern},
                            {"edges", summary.edges},
                            {"samples", summary.samples},
                            {"converged_samples", summary.converged_samples},
                            {"stable_samples", summary.stable_samples},
                            {"calibrations", summary.calibrations},
                            {"best_objective", base::or_null(summary.best_objective)},
                            {"failures", summary.failures}});
    }
    return {{"layout", library.layout().name()},
            {"content_hash", library.content_hash()},
            {"patterns", std::move(patterns)}};
}

void print_list(const std::vector<PatternSummary>& summaries) {
    std::size_t width = 2;
    for (const PatternSummary& summary : summaries) width = std::max(width, summary.pattern.size());
    std::printf("%-*s  edges  samples  converged  stable  calibrations  best E\n", static_cast<int>(width),
                "id");
    for (const PatternSummary& summary : summaries) {
        std::printf("%-*s  %5d  %7d  %9d  %6d  %12d  ", static_cast<int>(width), summary.pattern.c_str(),
                    summary.edges, summary.samples, summary.converged_samples, summary.stable_samples,
                    summary.calibrations);
        if (summary.best_objective) std::printf("%6.3f", *summary.best_objective);
        std::printf("%s\n", summary.failures > 0 ? "  failed: see library show for the reason" : "");
    }
}

void print_totals(const Library& library, const std::vector<PatternSummary>& summaries) {
    const auto count = [&](auto&& predicate) { return std::ranges::count_if(summaries, predicate); };
    std::printf("\n%zu patterns of the layout %s: %td with responses, %td calibrated, %td with failures\n",
                summaries.size(), base::printable(library.layout().name()).c_str(),
                count([](const PatternSummary& s) { return s.samples > 0; }),
                count([](const PatternSummary& s) { return s.calibrations > 0; }),
                count([](const PatternSummary& s) { return s.failures > 0; }));
}

void list(const LibraryOptions& options) {
    const Library library = open_library(options);
    const std::vector<PatternSummary> summaries = library.summaries();
    if (options.json) {
        print_document(list_json(library, summaries));
        return;
    }
    print_list(summaries);
    print_totals(library, summaries);
}

// ---- show ----

exports::ReducedPattern reduced_pattern(const Library& library, const pattern::NamedPattern& entry) {
    return {entry.pattern, library.best_fit(entry.id)};
}

void show(const LibraryOptions& options) {
    const Library library = open_library(options);
    const pattern::NamedPattern entry = library.find_pattern(options.pattern);
    if (!options.svg.empty()) {
        const exports::ReducedPattern drawn = reduced_pattern(library, entry);
        base::write_file_atomically(
            options.svg, exports::reduced_sheet_svg(library.layout(), {&drawn, 1}, library.setting()));
    }
    if (!options.scenarios.empty())
        base::write_file_atomically(
            options.scenarios, exports::scenario_sheet_svg(library.layout(), reduced_pattern(library, entry),
                                                           library.setting()));
    options.json ? print_pattern_json(library, entry) : print_pattern(library, entry);
}

// ---- find ----

void find(const LibraryOptions& options) {
    print_found(open_library(options), options.query, options.json);
}

// ---- merge and export ----

void merge(const LibraryOptions& options) {
    if (!options.library.empty())
        throw base::InputError("--library", "",
                               "is for list, find, show and export: merge OUTPUT INPUT.. names its own");
    LongWork work;
    library::merge(options.output, options.inputs, work.control());
    const Library merged = Library::open(options.output);
    if (options.json) {
        print_document({{"library", options.output},
                        {"patterns", merged.pattern_count()},
                        {"content_hash", merged.content_hash()}});
    } else {
        print_totals(merged, merged.summaries());
    }
}

std::string pattern_sheet(const Library& library, std::span<const pattern::NamedPattern> wanted,
                          const base::Control& control) {
    std::vector<exports::ReducedPattern> patterns;
    for (const pattern::NamedPattern& entry : wanted) {
        control.check();
        patterns.push_back(reduced_pattern(library, entry));
    }
    return exports::reduced_sheet_svg(library.layout(), patterns, library.setting());
}

std::string property_chart(const Library& library, const base::Control& control) {
    std::vector<exports::PatternProperties> patterns;
    for (const pattern::NamedPattern& entry : library.patterns()) {
        control.check();
        const auto properties = library.properties(entry.id);
        if (!properties.empty()) patterns.push_back({entry.pattern, {properties.begin(), properties.end()}});
    }
    if (patterns.empty()) {
        throw base::InputError(library.path().string(), "",
                               "has no properties to chart yet; fretwork calibrate computes them");
    }
    return exports::property_chart_svg({library.layout(), library.setting()}, patterns);
}

void check_export_options(const LibraryOptions& options) {
    const bool uses_patterns = !options.meshes.empty() || !options.svg.empty() || !options.stiffness.empty();
    if (options.csv.empty() && options.chart.empty() && !uses_patterns) {
        throw base::InputError("library export", "",
                               "needs --csv DIR, --meshes DIR, --stiffness DIR, --svg FILE or --chart FILE");
    }
    if (options.patterns != "all" && !uses_patterns)
        throw base::InputError("--patterns", "",
                               "is for --svg, --meshes and --stiffness, and none of them is given");
    if (options.json)
        throw base::InputError("--json", "", "is for list, find, show and merge: export prints nothing");
}

void write_files(const LibraryOptions& options) {
    check_export_options(options);
    LongWork work;
    const Library library = open_library(options);
    const base::Control control = work.control();
    const std::vector<pattern::NamedPattern> wanted = wanted_patterns(library, options.patterns);
    base::FileBatch drawings;
    if (!options.svg.empty()) drawings.add(options.svg, pattern_sheet(library, wanted, control));
    if (!options.chart.empty()) drawings.add(options.chart, property_chart(library, control));
    std::vector<base::FolderBatch> folders;
    if (!options.csv.empty()) library.export_csv(folders.emplace_back(options.csv).path(), control);
    if (!options.meshes.empty()) {
        const exports::MeshOptions meshes{
            .kind = options.ply ? exports::MeshKind::Ply : exports::MeshKind::Obj, .control = control};
        exports::add_meshes(library, wanted, meshes, folders.emplace_back(options.meshes));
    }
    if (!options.stiffness.empty()) {
        base::FolderBatch& batch = folders.emplace_back(options.stiffness);
        exports::add_stiffness(library, wanted, {.control = control}, batch);
        exports::require_same_stiffness(options.stiffness, batch, control);
    }
    control.check();
    for (base::FolderBatch& folder : folders) folder.commit();
    drawings.commit();
}

using Action = void (*)(const LibraryOptions&);

CLI::App* add_action(CLI::App* verb, const std::shared_ptr<LibraryOptions>& options, const char* name,
                     std::pair<const char*, Action> what) {
    CLI::App* action = verb->add_subcommand(name, what.first);
    action->fallthrough();
    action->footer(kExamples);
    action->callback([options, run = what.second] { run(*options); });
    return action;
}

void add_find(CLI::App& verb, const std::shared_ptr<LibraryOptions>& options) {
    CLI::App* finding = add_action(&verb, options, "find",
                                   {"Find patterns by their behaviour: stiffness, mass, objective", find});
    finding
        ->add_option(
            "--where", options->query.where,
            "Condition, such as \"bending_stiffness between 0.07 and 0.09 and bending_poisson < 0\": an "
            "SQL expression of the columns that are printed (default: every pattern whose behaviour is "
            "known)")
        ->type_name("EXPRESSION");
    finding->add_option("--sort", options->query.sort, "Expression to sort by (default: the pattern's id)")
        ->type_name("EXPRESSION");
    finding->add_flag("--descending", options->query.descending, "Largest first");
    finding->add_option("--limit", options->query.limit, "Maximum number of patterns to print (default: all)")
        ->check(CLI::Range(1, 1'000'000'000));
}

}  // namespace

void add_library(CLI::App& app, ExitCode&) {
    const auto options = std::make_shared<LibraryOptions>();
    CLI::App* verb = app.add_subcommand(
        "library", "List, find and show the content of a pattern library, merge libraries, write tables");
    verb->require_subcommand(1);
    verb->footer(kExamples);
    verb->add_option("--library", options->library, "The library's file (list, find, show, export)");
    verb->add_flag("--json", options->json, "Print JSON (list, find, show, merge)");

    add_action(verb, options, "list", {"List the patterns with a summary of the data of each", list});
    add_find(*verb, options);
    CLI::App* showing =
        add_action(verb, options, "show", {"Show one pattern with its responses and calibrations", show});
    showing->add_option("--svg", options->svg, "Draw the pattern and its reduced model");
    showing->add_option("--scenarios", options->scenarios,
                        "Draw the pattern and its reduced model with supports, loads and deformed shape in "
                        "each scenario, as SVG");
    showing->add_option("pattern", options->pattern, "The pattern's id, such as 0-1+1-6")->required();
    CLI::App* merging = add_action(verb, options, "merge",
                                   {"Merge libraries of one layout and setting into a new file", merge});
    merging->add_option("output", options->output, "The file to make")->required();
    merging->add_option("inputs", options->inputs, "The libraries")->required();
    CLI::App* exporting =
        add_action(verb, options, "export", {"Write tables and meshes for other programs", write_files});
    exporting->add_option("--csv", options->csv, "Folder for the tables, one CSV file each");
    exporting->add_option("--meshes", options->meshes,
                          "Folder for the edge mesh and the reduced model's geometry of each pattern");
    exporting->add_option("--stiffness", options->stiffness,
                          "Folder for stiffness.npy (patterns x 6n x 6n, SI, n interface nodes, for small "
                          "displacements) and patterns.txt, the patterns in its order; files that are there "
                          "and differ are not replaced");
    exporting->add_option("--svg", options->svg, "Sheet of the patterns with their reduced models");
    exporting->add_option("--patterns", options->patterns,
                          "Patterns that --svg, --meshes and --stiffness write: all, computed (those with "
                          "responses), ids joined by commas, or sample:N");
    exporting->add_option(
        "--chart", options->chart,
        "Property chart as SVG: stiffness against mass, bending against in-plane stiffness");
    exporting->add_flag("--ply", options->ply, "Write meshes as PLY rather than OBJ")->needs("--meshes");
    declare_files(*verb, {input("--library")});
    declare_files(*showing, {output("--svg", kSvgFile), output("--scenarios", kSvgFile)});
    declare_files(*merging, {output("output", kLibraryFile), input("inputs")});
    declare_files(*exporting, {output_folder("--csv", kTables), output_folder("--meshes", ".obj .ply"),
                               compared_folder("--stiffness", "stiffness.npy patterns.txt"),
                               output("--svg", kSvgFile), output("--chart", kSvgFile)});
}

}  // namespace fretwork::app
