// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings, pages and files of what the other stages make.
#include "core/bind.hpp"
#include "reduction/library_object.hpp"
#include "reduction/tile_builds.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/drawings/pattern_drawing.hpp>
#include <fretwork/exports/drawings/property_chart.hpp>
#include <fretwork/exports/space/bar_scene.hpp>
#include <fretwork/exports/writer_catalogue.hpp>
#include <fretwork/simulation/results/result_subject.hpp>

#include <typed/making_choice.hpp>
#include <typed/picture_options.hpp>

namespace fretwork::python {
namespace {

using namespace exports;
using simulation::LoadCase;
using simulation::Surface;
using simulation::SurfaceResult;

/// A text; '' for None.
std::string text_of(const py::object& given) {
    return given.is_none() ? std::string() : given.cast<std::string>();
}

void take_text(py::dict& named, const char* name, std::string& value) {
    value = text_of(taken(named, name));
}

/// How a surface is made, from keywords with lengths as texts ("2mm").
typed::MakingChoice taken_making(py::dict& named) {
    typed::MakingChoice choice;
    choice.prefix = "";
    take_text(named, "fillet", choice.fillet);
    take_text(named, "kerf", choice.kerf);
    take_text(named, "frame", choice.frame);
    take_text(named, "bolts", choice.bolts);
    take_text(named, "eye", choice.eye);
    take_text(named, "bed", choice.bed);
    take_text(named, "fit", choice.fit);
    take_text(named, "clearance", choice.clearance);
    take_text(named, "layer", choice.layer);
    return choice;
}

/// Results with their labels in drawings: one, several, or a dict.
std::vector<Scene::LabelledResult> results_of(const py::object& given) {
    std::vector<Scene::LabelledResult> results;
    const auto add = [&](std::string label, const SurfaceResult& result) {
        results.push_back({std::move(label), result});
    };
    const auto own_label = [](const SurfaceResult& result) {
        return result.subject ? result.subject->model : std::string("result");
    };
    if (given.is_none()) return results;
    if (py::isinstance<SurfaceResult>(given)) {
        const auto& result = given.cast<const SurfaceResult&>();
        add(own_label(result), result);
    } else if (py::isinstance<py::dict>(given)) {
        for (const auto& [label, result] : py::reinterpret_borrow<py::dict>(given))
            add(label.cast<std::string>(), result.cast<const SurfaceResult&>());
    } else {
        for (const auto& result : given.cast<std::vector<SurfaceResult>>()) add(own_label(result), result);
    }
    return results;
}

/// Results must belong to the surface; without a subject, they must at least have its nodes.
void check_results(const Scene& scene) {
    std::optional<simulation::SurfaceIdentity> own;
    for (const Scene::LabelledResult& shown : scene.results) {
        require_same_surface(scene.surface, shown.result);
        if (!shown.result.subject) continue;
        if (!own) own = simulation::surface_identity(scene.surface);
        const std::string difference = simulation::subject_difference(*shown.result.subject, *own);
        if (!difference.empty())
            throw base::InputError("the result '" + shown.label +
                                   "' is not one of this surface: they differ in " + difference);
    }
}

/// Takes the picture's options out of keywords.
void take_picture(py::dict& named, Scene& scene) {
    const py::object scale = taken(named, "scale");
    if (!scale.is_none()) scene.displacement_scale = typed::checked_scale(scale.cast<double>());
    const std::string view = text_of(taken(named, "view"));
    if (!view.empty()) scene.view = typed::parse_view(view);
    const std::string size = text_of(taken(named, "size"));
    if (!size.empty()) scene.picture.size = typed::parse_size(size);
    const std::string colour = text_of(taken(named, "colour"));
    if (!colour.empty())
        scene.picture.colour = colour;
    else if (scene.results.empty())
        scene.picture.colour = "plain";
    const py::object strength = taken(named, "strength");
    if (!strength.is_none()) scene.strength = strength.cast<double>();
    if (const py::object labels = taken(named, "labels"); !labels.is_none())
        for (const auto& what : labels.cast<std::vector<std::string>>()) {
            if (what != "tiles" && what != "nodes")
                throw base::InputError("labels", "", "there are 'tiles' and 'nodes', and not '" + what + "'");
            (what == "tiles" ? scene.labels.tiles : scene.labels.interface_nodes) = DrawnLabels::Shown::Yes;
        }
}

/// A scene, and the tile models that it refers to.
struct OwnedScene {
    std::vector<reduction::TileModel> models;
    Scene scene;
};

OwnedScene make_scene(const Surface& surface, const py::object& results,
                      const std::optional<LoadCase>& load_case, py::dict named) {
    OwnedScene owned{taken_models(named), Scene{surface}};
    Scene& scene = owned.scene;
    scene.models = owned.models;
    scene.results = results_of(results);
    check_results(scene);
    if (load_case) {
        scene.conditions = simulation::resolve(*load_case, surface);
        scene.load_case = load_case;
    }
    take_picture(named, scene);
    scene.making = typed::read_making(taken_making(named), scene.conditions ? &*scene.conditions : nullptr);
    scene.making.facts.strength = scene.strength;
    scene.making.facts.models = owned.models;
    if (!named.empty())
        throw py::type_error("an export does not take " + py::cast<std::string>(py::str(py::list(named))));
    return owned;
}

constexpr const char* kSceneKeywords =
    "Options: scene, models, progress\n\nOptions of the scene: scale (of displacements), view ('iso', 'top', "
    "'30,20'), size ('1600x1000'), colour (one of bar_field_names(), or 'plain'), strength (Pa), labels "
    "(['tiles', 'nodes']); how the surface is made: fillet, kerf, frame, bolts, eye, bed, fit, clearance, "
    "layer, as texts with units ('2mm').\n";

/// Writes the files of an export, all of them or none. Returns the remarks.
std::vector<std::string> export_files(const Surface& surface, const std::vector<std::filesystem::path>& paths,
                                      const py::object& results, const std::optional<LoadCase>& load_case,
                                      const std::optional<Content>& content, const py::kwargs& named) {
    py::dict others(named.attr("copy")());
    const py::object progress = taken(others, "progress");
    OwnedScene owned = make_scene(surface, results, load_case, others);
    return run_long(progress, [&](const base::Control& control) {
        owned.scene.control = control;
        base::FileBatch files;
        std::vector<std::string> remarks;
        for (const std::filesystem::path& path : paths) {
            const Written written = find_writer(path, content).write(owned.scene);
            files.add(path, written.text);
            remarks.insert(remarks.end(), written.remarks.begin(), written.remarks.end());
        }
        files.commit();
        return remarks;
    });
}

void bind_writers(py::module_& m) {
    bind_enum<Content>(m);
    bind_enum<WriterRow::Kind>(m);
    Record<WriterRow>(m, "WriterRow", "A kind of file.")
        .constant("ending", &WriterRow::ending, "with its dot")
        .constant("content", &WriterRow::content, "")
        .constant("description", &WriterRow::description, "")
        .constant("kind", &WriterRow::kind, "")
        .done(Made::ByFunctions);
    m.def(
        "writer_catalogue", [] { return writer_catalogue(); }, "All kinds of files.");
    m.def(
        "export",
        [](const Surface& surface,
           const std::variant<std::filesystem::path, std::vector<std::filesystem::path>>& to,
           const py::object& results, const std::optional<LoadCase>& load_case,
           const std::optional<Content>& content, const py::kwargs& named) {
            const auto* one = std::get_if<std::filesystem::path>(&to);
            return export_files(surface, one != nullptr ? std::vector{*one} : std::get<1>(to), results,
                                load_case, content, named);
        },
        "surface"_a, "to"_a, "results"_a = py::none(), "load_case"_a = py::none(), "content"_a = py::none(),
        (std::string(
             "Write a surface and its results as files; the endings of their names select the kinds. "
             "`results` is one result, a list, or a dict of labels and results. Returns remarks.\n\n") +
         kSceneKeywords)
            .c_str());
    m.def(
        "export_content",
        [](const Surface& surface, const std::string& ending, const py::object& results,
           const std::optional<LoadCase>& load_case, const std::optional<Content>& content,
           const py::kwargs& named) {
            py::dict others(named.attr("copy")());
            const py::object progress = taken(others, "progress");
            OwnedScene owned = make_scene(surface, results, load_case, others);
            return py::bytes(run_long(progress, [&](const base::Control& control) {
                owned.scene.control = control;
                return find_writer("file" + ending, content).write(owned.scene).text;
            }));
        },
        "surface"_a, "ending"_a, "results"_a = py::none(), "load_case"_a = py::none(),
        "content"_a = py::none(),
        (std::string("The bytes of a file; `ending` is '.svg', '.html', '.stl', ..\n\n") + kSceneKeywords)
            .c_str());
    m.def("bar_field_names", &bar_field_names, "The fields that a picture's colours can show.");
    bind_enum<MeshKind>(m);
}

void bind_drawing_options(py::module_& m) {
    Record<PatternDrawingOptions>(m, "PatternDrawingOptions", "Options of drawings of fans.")
        .field("tile_side", &PatternDrawingOptions::tile_side, "m")
        .field("beam_width", &PatternDrawingOptions::beam_width, "m")
        .field("sides", &PatternDrawingOptions::sides, "")
        .done();
    Record<PatternProperties>(m, "PatternProperties", "A pattern and its effective properties by name.")
        .field("pattern", &PatternProperties::pattern, "")
        .field("values", &PatternProperties::values, "")
        .done();
    Record<ReducedPattern>(m, "ReducedPattern", "A pattern with a reduced model fitted to it.")
        .field("pattern", &ReducedPattern::pattern, "")
        .field("calibration", &ReducedPattern::calibration, "")
        .done();
}

void bind_drawings(py::module_& m) {
    m.def(
        "pattern_sheet_svg",
        [](const pattern::NodeLayout& layout, const std::vector<pattern::Pattern>& patterns,
           const PatternDrawingOptions& options) {
            check(layout, patterns);
            return pattern_sheet_svg(layout, patterns, options);
        },
        "layout"_a, "patterns"_a, "options"_a = PatternDrawingOptions{},
        "A drawing of the layout with its candidate edges, and of patterns as a sheet of fans.");
    m.def(
        "rejection_sheet_svg",
        [](const pattern::NodeLayout& layout, const std::vector<pattern::Rejection>& rejections,
           const PatternDrawingOptions& options) {
            for (const pattern::Rejection& rejection : rejections) check(layout, rejection.pattern);
            return rejection_sheet_svg(layout, rejections, options);
        },
        "layout"_a, "rejections"_a, "options"_a = PatternDrawingOptions{},
        "A drawing of rejected graphs with the reasons.");
    m.def(
        "property_chart_svg",
        [](const pattern::NodeLayout& layout, const reduction::Setting& setting,
           const std::vector<PatternProperties>& patterns) {
            for (const PatternProperties& entry : patterns) check(layout, entry.pattern);
            return property_chart_svg({layout, setting}, patterns);
        },
        "layout"_a, "setting"_a, "patterns"_a,
        "Charts of stiffness against mass, and of bending against in-plane stiffness.");
    m.def(
        "reduced_sheet_svg",
        [](const pattern::NodeLayout& layout, const std::vector<ReducedPattern>& patterns,
           const reduction::Setting& setting) {
            for (const ReducedPattern& entry : patterns) check(layout, entry.pattern);
            setting.validate();
            return reduced_sheet_svg(layout, patterns, setting);
        },
        "layout"_a, "patterns"_a, "setting"_a,
        "A drawing of patterns with their reduced models beside them.");
    m.def(
        "scenario_sheet_svg",
        [](const pattern::NodeLayout& layout, const ReducedPattern& pattern,
           const reduction::Setting& setting) {
            check(layout, pattern.pattern);
            setting.validate();
            return scenario_sheet_svg(layout, pattern, setting);
        },
        "layout"_a, "pattern"_a, "setting"_a,
        "A drawing of the setting's scenarios on one tile, side by side.");
    m.def(
        "surface_svg",
        [](const Surface& surface, const std::optional<LoadCase>& load_case) {
            if (!load_case) return surface_svg(surface);
            const simulation::Conditions conditions = simulation::resolve(*load_case, surface);
            return surface_svg(surface, &conditions);
        },
        "surface"_a, "load_case"_a = py::none(),
        "A drawing of a surface from above, with supports and loads.");
    m.def("pattern_colour", &pattern_colour, "index"_a,
          "The colour of the i-th pattern of a palette: '#rrggbb'.");
}

}  // namespace

void bind_exports(py::module_& m) {
    bind_writers(m);
    bind_drawing_options(m);
    bind_drawings(m);
}

}  // namespace fretwork::python
