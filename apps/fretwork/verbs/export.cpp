// SPDX-License-Identifier: GPL-3.0-or-later
// fretwork export: a project, and what was computed of it, as a drawing or a file for other programs.
#include "bar_checks.hpp"
#include "interrupt.hpp"
#include "options/checks.hpp"
#include "options/file_options.hpp"
#include "options/making_options.hpp"
#include "output.hpp"
#include "surface_result.hpp"
#include "verbs.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/space/bar_scene.hpp>
#include <fretwork/exports/tables/line_set.hpp>
#include <fretwork/exports/writer_catalogue.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <fretwork/simulation/results/result_subject.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <typed/picture_options.hpp>

namespace fretwork::app {
namespace {

struct ExportOptions {
    std::string project;
    std::vector<std::string> to;
    std::string load_case;
    std::vector<std::string> results;
    std::string library;
    std::string scale = "1";
    std::string view;
    std::string size;
    std::string colour;
    bool no_ghost = false;
    std::string strength;
    std::vector<std::string> labels;
    std::string content;
    typed::MakingChoice making;
    bool json = false;
};

/// Parses an option's text by `parse`; errors name the option.
template <class Value>
Value read_option(const std::string& option, const std::string& text, Value (*parse)(const std::string&)) {
    return base::located(option, "", [&] { return parse(text); });
}

/// The surface to which results must belong.
struct OwnSurface {
    const simulation::Surface& surface;
    simulation::SurfaceIdentity identity;
};

/// A result that was read from a file must be one of the surface.
void check_own_result(const simulation::SurfaceResult& result, const std::string& file,
                      const OwnSurface& own) {
    check_subject_of(own.identity, result, file);
    base::located(file, "", [&] { exports::require_same_surface(own.surface, result); });
}

const exports::WriterRow& writer_of(const ExportOptions& options, const std::string& path) {
    const auto content =
        options.content.empty()
            ? std::nullopt
            : std::optional(read_option("--content", options.content, &exports::parse_content));
    return exports::find_writer(path, content);
}

using Writers = std::vector<const exports::WriterRow*>;

bool any_is(const Writers& writers, bool (exports::WriterRow::*is)() const) {
    return std::ranges::any_of(writers, [&](const auto* writer) { return (writer->*is)(); });
}

/// Refuses options that none of the drawings uses. An .svg shows the surface from above if there is no
/// result, or if there are results and a case: then beside the deformed surfaces.
void refuse_ignored_in_drawings(const CLI::App& verb, const ExportOptions& options, const Writers& writers) {
    const bool has_svg = std::ranges::any_of(
        writers, [](const auto* writer) { return writer->is_drawing() && !writer->is_picture(); });
    const bool has_picture = std::ranges::any_of(
        writers, [](const auto* writer) { return writer->is_picture() && writer->has_view(); });
    const bool is_from_above = options.results.empty() || !options.load_case.empty();
    if (!has_svg || !is_from_above)
        refuse_given(verb, {"--labels"},
                     "is for drawings from above, which are .svg without --result, or with --case, too");
    const bool has_view = has_picture || (has_svg && !options.results.empty());
    if (!has_view)
        refuse_given(verb, {"--view"}, "is for bent surfaces (--result) and pictures (.png, .html)");
    const bool tells_strength = std::ranges::any_of(writers, [](const auto* writer) {
        return writer->is_picture() || writer->content == exports::Content::Facts || writer->ending == ".vtu";
    });
    if (!tells_strength) refuse_given(verb, {"--strength"}, "is for pictures, facts and .vtu");
}

/// Refuses options that no file to write makes use of.
void refuse_ignored_options(const CLI::App& verb, const ExportOptions& options) {
    Writers writers;
    for (const std::string& path : options.to) writers.push_back(&writer_of(options, path));
    refuse_ignored_making(verb, writers);
    const bool has_facts = std::ranges::any_of(
        writers, [](const auto* writer) { return writer->content == exports::Content::Facts; });
    if (!any_is(writers, &exports::WriterRow::is_drawing)) {
        refuse_given(verb, {"--scale", "--view", "--labels"},
                     "is for drawings, and no --to names one (.svg, .png, .html, .glb)");
        if (options.making.bolts.empty() && !has_facts)
            refuse_given(verb, {"--case"},
                         "is for drawings, facts and --bolts, and none of them is asked for");
    }
    refuse_ignored_in_drawings(verb, options, writers);
    if (!any_is(writers, &exports::WriterRow::is_picture))
        refuse_given(verb, {"--colour"}, "is for pictures, and no --to names one (.png, .html, .glb)");
    if (options.results.empty() && options.colour != "plain")
        refuse_given(verb, {"--colour"},
                     "shows what a result has, and there is no --result; plain needs none");
    const bool has_pixels = std::ranges::any_of(
        options.to, [&](const std::string& path) { return writer_of(options, path).ending == ".png"; });
    if (!has_pixels)
        refuse_given(verb, {"--size", "--no-ghost"},
                     "is for pictures made of pixels, and no --to names one (.png)");
}

/// The supports and loads that are drawn must be those of the results.
void check_load_case(const simulation::LoadCase& load_case, const ExportOptions& options,
                     const exports::Scene& scene) {
    const auto drawn = simulation::result_subject(scene.surface, load_case, {});
    for (std::size_t i = 0; i < scene.results.size(); ++i) {
        const std::string difference =
            simulation::subject_difference(*scene.results[i].result.subject, drawn);
        if (!difference.empty())
            throw base::InputError(options.results[i], "",
                                   "is not a result of the load case '" + load_case.name +
                                       "' of --case: they differ in " + difference);
    }
}

/// The library is opened on request, for a project without a setting, and if the tiles of a result are
/// calibrated.
bool needs_library(const ExportOptions& options, const simulation::Project& project,
                   const std::vector<exports::Scene::LabelledResult>& results) {
    if (!options.library.empty() || !project.setting) return true;
    return std::ranges::any_of(results, [&](const exports::Scene::LabelledResult& shown) {
        const std::string model = simulation::main_model(*shown.result.subject);
        return simulation::needs_library(project, simulation::model_choice({.model = model}));
    });
}

/// Results of different models have the models' names in legends, others the names of their files.
void name_by_models(std::vector<exports::Scene::LabelledResult>& results) {
    std::set<std::string> models;
    for (const auto& shown : results) models.insert(shown.result.subject->model);
    if (models.size() < results.size()) return;
    for (auto& shown : results) shown.label = shown.result.subject->model;
}

exports::Scene make_scene(const ExportOptions& options, const base::Control& control) {
    const simulation::Project project = simulation::read_checked_project(options.project);
    std::vector<exports::Scene::LabelledResult> results;
    for (const std::string& file : options.results) {
        control.check();
        results.push_back({std::filesystem::path(file).stem().string(), read_surface_result(file)});
    }
    name_by_models(results);
    std::optional<library::Library> library;
    if (needs_library(options, project, results))
        library = simulation::open_project_library(options.project, project, options.library);
    exports::Scene scene{simulation::make_surface(project, library ? &*library : nullptr)};
    OwnSurface own{scene.surface, {}};
    if (!options.results.empty()) own.identity = simulation::surface_identity(scene.surface);
    for (std::size_t i = 0; i < results.size(); ++i) {
        control.check();
        check_own_result(results[i].result, options.results[i], own);
    }
    scene.results = std::move(results);
    if (!options.load_case.empty()) {
        const simulation::LoadCase load_case = base::located(
            options.project, "", [&] { return simulation::find_load_case(project, options.load_case); });
        check_load_case(load_case, options, scene);
        scene.conditions = simulation::resolve(load_case, scene.surface);
        scene.load_case = load_case;
    }
    scene.displacement_scale = read_option("--scale", options.scale, typed::parse_scale);
    if (!options.view.empty()) scene.view = read_option("--view", options.view, typed::parse_view);
    if (!options.size.empty()) scene.picture.size = read_option("--size", options.size, typed::parse_size);
    if (!options.colour.empty()) scene.picture.colour = options.colour;
    if (options.no_ghost) scene.picture.ghost = exports::PictureOptions::Ghost::Hidden;
    if (!options.strength.empty()) scene.strength = parse_strength(options.strength);
    if (options.colour == exports::kUtilization && !scene.known_strength())
        throw base::InputError(
            "--colour", "",
            "utilization needs a strength: give --strength, or write \"strength\" into the "
            "material of the setting");
    for (const std::string& what : options.labels)
        (what == "tiles" ? scene.labels.tiles : scene.labels.interface_nodes) =
            exports::DrawnLabels::Shown::Yes;
    scene.making = typed::read_making(options.making, scene.conditions ? &*scene.conditions : nullptr);
    scene.making.facts.strength = scene.strength;
    scene.control = control;
    return scene;
}

/// A line for each file: its path, its content, the unit of its lengths, its size. Reports name their units
/// themselves.
void print_written(const base::Json& report) {
    for (const base::Json& file : report["files"]) {
        const bool is_report = file["content"] == "facts";
        const auto unit = is_report ? "none" : file["unit"].get<std::string>();
        std::printf("%s: %s%s, %s\n", base::printable(file["path"].get<std::string>()).c_str(),
                    file["content"].get<std::string>().c_str(),
                    unit == "none" ? "" : (", lengths in " + unit + "s").c_str(),
                    bytes_text(file["bytes"].get<std::size_t>()).c_str());
    }
}

void run(const ExportOptions& options) {
    for (const std::string& path : options.to) (void)writer_of(options, path);
    (void)read_option("--scale", options.scale, typed::parse_scale);
    LongWork work;
    const base::Control control = work.control();
    const exports::Scene scene = make_scene(options, control);
    base::FileBatch files;
    base::Json report = {{"files", base::Json::array()}};
    std::vector<std::string> remarks;
    for (const std::string& path : options.to) {
        control.check();
        const exports::WriterRow& writer = writer_of(options, path);
        const exports::Written written = writer.write(scene);
        files.add(path, written.text);
        for (const std::string& remark : written.remarks)
            if (std::ranges::find(remarks, remark) == remarks.end()) remarks.push_back(remark);
        report["files"].push_back({{"path", path},
                                   {"content", exports::content_name(writer.content)},
                                   {"unit", exports::unit_of(writer)},
                                   {"bytes", written.text.size()},
                                   {"remarks", written.remarks}});
    }
    control.check();
    files.commit();
    for (const std::string& remark : remarks) warn(remark);
    if (options.json)
        print_document(report);
    else
        print_written(report);
}

std::string kinds_help() {
    std::string text = "File to write (repeatable). Its ending selects the kind of file:";
    for (const exports::WriterRow& writer : exports::writer_catalogue()) {
        text +=
            "\n  " + std::string(writer.ending) +
            (exports::is_default(writer) ? "" : " --content " + std::string(content_name(writer.content))) +
            ": " + std::string(writer.description);
    }
    return text;
}

}  // namespace

void add_export(CLI::App& app, ExitCode&) {
    CLI::App* verb = app.add_subcommand(
        "export", "Write a project and its results as drawings and as files for other programs");
    const auto options = std::make_shared<ExportOptions>();
    verb->add_option("project", options->project, "Project file")->required();
    verb->add_option("--to", options->to, kinds_help())->required()->allow_extra_args(false);
    verb->add_option("--content", options->content,
                     "Content of the files, for endings that can have several: drawing, centrelines, cut, "
                     "solid or facts")
        ->type_name("CONTENT");
    verb->add_option("--case", options->load_case,
                     "Load case for drawings (supports and loads), for facts (sag and stresses), and for "
                     "--bolts (holes at its supports)");
    verb->add_option("--result", options->results,
                     "Result file of this project (repeatable; an .svg draws all results over each other)")
        ->allow_extra_args(false);
    verb->add_option("--library", options->library, "Library with the setting (default: the project's)");
    verb->add_option("--scale", options->scale, "Factor on the displacements in drawings")
        ->capture_default_str();
    verb->add_option("--view", options->view,
                     "Direction of view of a .png, of an .html, or of a deformed surface in an .svg: iso, "
                     "front, right, back, left, top, or AZIMUTH,ELEVATION in degrees (default: the direction "
                     "that shows most)")
        ->type_name("VIEW");
    verb->add_option("--size", options->size, "Width and height of a .png in pixels (default: 1600x1000)")
        ->type_name("WxH");
    verb->add_option("--colour", options->colour,
                     "Field that the colours of .png, .html and .glb show: " +
                         base::join(exports::bar_field_names(), ", ") + ", or plain (default: displacement)")
        ->type_name("FIELD");
    verb->add_flag("--no-ghost", options->no_ghost, "Do not draw the shape at rest in a .png");
    verb->add_option(
            "--strength", options->strength,
            "Strength of the material, such as 40MPa (default: that of the setting's material): .vtu, .png, "
            ".html and .glb then have utilization, and facts compare stresses with the strength")
        ->type_name("STRESS");
    verb->add_option("--labels", options->labels,
                     "Numbers to draw in an .svg from above: of tiles, of nodes (the interface nodes), or of "
                     "both (tiles,nodes)")
        ->delimiter(',')
        ->check(CLI::IsMember({"tiles", "nodes"}))
        ->type_name("WHAT");
    add_making_options(*verb, options->making);
    verb->add_flag("--json", options->json, "Print what was written as JSON");
    declare_files(*verb,
                  {input("project"), output("--to", kExportFile), input("--result"), input("--library")});
    verb->footer(
        "Example: fretwork export project.json --result full.json --result condensed.json --to deformed.svg\n"
        "         fretwork export project.json --result full.json --to view.html --to picture.png --view "
        "-35,25\n"
        "         fretwork export project.json --to cut.dxf --kerf 0.15mm --fillet 0.5mm --bed 600x400\n"
        "         fretwork export project.json --to solid.stl --to solid.3mf --frame 4mm\n"
        "         fretwork export project.json --content facts --case hanging --strength 50MPa --to "
        "facts.html");
    verb->callback([options, verb] {
        refuse_ignored_options(*verb, *options);
        run(*options);
    });
}

}  // namespace fretwork::app
