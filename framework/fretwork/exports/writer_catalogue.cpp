// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/drawings/detail/bent_beams.hpp>
#include <fretwork/exports/drawings/surface_drawing.hpp>
#include <fretwork/exports/making/making_files.hpp>
#include <fretwork/exports/space/pictures.hpp>
#include <fretwork/exports/tables/line_files.hpp>
#include <fretwork/exports/writer_catalogue.hpp>
#include <fretwork/fabrication/shape.hpp>
#include <fretwork/simulation/surface_frame.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <algorithm>
#include <array>

namespace fretwork::exports {
namespace {

LineSet main_lines(const Scene& scene) {
    return scene.results.empty() ? surface_lines(scene.surface)
                                 : result_lines(scene.surface, scene.results.front().result);
}

/// The colour of a layer by its index: first the paper's grey (full model), then its blue (reduced model),
/// then further colours.
std::string layer_colour(std::size_t index) {
    constexpr std::array<const char*, 4> kColours = {"#8a8f94", "#2166ac", "#d6604d", "#1b7837"};
    return kColours[index % kColours.size()];
}

bool is_calibrated(const simulation::Surface& surface, const std::string& model) {
    const auto has_model = [&](const std::vector<reduction::Calibration>& of_pattern) {
        return std::ranges::find(of_pattern, model, &reduction::Calibration::model) != of_pattern.end();
    };
    const auto used = tiling::used_patterns(surface.tessellation);
    return surface.calibrations.size() == surface.tessellation.patterns.size() &&
           std::ranges::all_of(used, [&](std::size_t p) { return has_model(surface.calibrations[p]); });
}

/// The beams of a reduced model at rest. None unless the result's model has parameters and small
/// displacements, as the paper's has, and the surface has its calibrations.
std::optional<mechanics::Frame> own_beams(const Scene& scene, const Scene::LabelledResult& entry) {
    if (!entry.result.subject) return std::nullopt;
    const auto model =
        std::ranges::find(scene.models, entry.result.subject->model, &reduction::TileModel::name);
    if (model == scene.models.end() || model->parameters.empty()) return std::nullopt;
    if (model->displacements != reduction::Displacements::Small) return std::nullopt;
    if (!is_calibrated(scene.surface, model->name)) return std::nullopt;
    const simulation::ModelChoice choice{model->name, scene.models};
    return simulation::tile_beams(scene.surface, choice, scene.control.silent());
}

/// The lines of a result: bent `beams` if they are given, or result_lines().
LineSet drawn_lines(const Scene& scene, const Scene::LabelledResult& entry,
                    const std::optional<mechanics::Frame>& beams) {
    if (!beams) return result_lines(scene.surface, entry.result);
    require_same_surface(scene.surface, entry.result);
    const auto moved = static_cast<Eigen::Index>(scene.surface.tessellation.interface_nodes.size());
    return detail::bent_beams(*beams, entry.result.solution.displacements.topRows(moved));
}

std::string svg_text(const Scene& scene) {
    DeformedViewOptions options;
    options.scale = scene.displacement_scale;
    options.joints = scene.surface.setting.joints;
    if (scene.view) options.view = *scene.view;
    options.rest = rim_lines(scene.surface);
    options.labels = scene.labels;
    std::vector<DeformedLayer> layers;
    for (const Scene::LabelledResult& entry : scene.results) {
        const std::optional<mechanics::Frame> beams = own_beams(scene, entry);
        if (beams && options.reduced.lines.empty()) options.reduced = frame_lines(*beams);
        layers.push_back({entry.label, layer_colour(layers.size()), drawn_lines(scene, entry, beams)});
    }
    if (scene.conditions && layers.empty())
        return surface_svg(scene.surface, &*scene.conditions, scene.labels);
    if (scene.conditions) return figure_svg(scene.surface, *scene.conditions, layers, options);
    if (layers.empty()) return surface_svg(scene.surface, nullptr, scene.labels);
    return layers.size() == 1 ? displacement_svg(layers.front(), options) : deformed_svg(layers, options);
}

/// The options for making. Throws InputError if a result does not belong to the surface.
fabrication::ShapeOptions making(const Scene& scene) {
    for (const Scene::LabelledResult& entry : scene.results)
        require_same_surface(scene.surface, entry.result);
    fabrication::ShapeOptions options = scene.making.shape;
    options.control = scene.control;
    return options;
}

Written cut_sheets(const Scene& scene, std::string (*text)(const fabrication::CutSheet&)) {
    const fabrication::ShapeOptions options = making(scene);
    const fabrication::Bed& bed = *scene.making.bed;
    fabrication::SheetSet set = cut_into_sheets(scene.surface, options, bed);
    return {text(side_by_side(set, bed)), std::move(set.remarks)};
}

Written cut(const Scene& scene, std::string (*text)(const fabrication::CutSheet&)) {
    if (scene.making.bed) return cut_sheets(scene, text);
    auto [shape, remarks] = fabrication::make_remarked_shape(scene.surface, making(scene));
    return {text(fabrication::sheet_of_shape(scene.surface, shape)), std::move(remarks)};
}

fabrication::Facts scene_facts(const Scene& scene) {
    fabrication::FactsOptions options = scene.making.facts;
    options.models = scene.models;
    options.control = scene.control;
    options.bed = scene.making.bed;
    const fabrication::FactsLoads loads{scene.load_case ? &*scene.load_case : nullptr,
                                        scene.results.empty() ? nullptr : &scene.results.front().result};
    return facts(scene.surface, making(scene), loads, options);
}

/// Chords of a print may be off by a twentieth of a nozzle. Files are then a third as large as with the
/// default of 5 micrometres.
constexpr double kPrintTolerance = 2e-5;  // m

Written solid(const Scene& scene, std::string (*text)(const fabrication::Solid&)) {
    auto [shape, remarks] = fabrication::make_remarked_shape(scene.surface, making(scene).without_kerf());
    const fabrication::Solid solid =
        fabrication::make_solid(shape, {.chord_tolerance = kPrintTolerance, .control = scene.control});
    return {text(solid), std::move(remarks)};
}

using Kind = WriterRow::Kind;

constexpr std::array<WriterRow, 18> kWriters = {{
    {".svg", Content::Drawing,
     "drawing: without a result, the surface from above; with one result, the bent surface coloured by "
     "displacement; with several, the bent surfaces over each other; with results and a load case, all "
     "drawings on one sheet",
     [](const Scene& scene) { return Written{svg_text(scene)}; }, Kind::Drawing},
    {".png", Content::Drawing,
     "picture in perspective: the bars, bent by the first result, and their shape at rest, on a transparent "
     "background; with a load case also its supports",
     [](const Scene& scene) { return Written{picture_png(scene)}; }, Kind::Picture},
    {".html", Content::Drawing,
     "page for any browser, in one file: the same bars, at rest or deformed, which can be turned and zoomed",
     [](const Scene& scene) { return Written{view_html(scene)}; }, Kind::Picture},
    {".glb", Content::Drawing,
     "animated glTF for slides and 3D programs: the same bars, moving from rest through the load steps of "
     "the "
     "first result",
     [](const Scene& scene) { return Written{motion_glb(scene)}; }, Kind::Motion},
    {".dxf", Content::Cut, "outline for cutting: closed lines with true arcs, in millimetres, in layers",
     [](const Scene& scene) { return cut(scene, cut_dxf); }, Kind::Made},
    {".stl", Content::Solid, "solid for printing: closed, in millimetres (binary)",
     [](const Scene& scene) { return solid(scene, solid_stl); }, Kind::Made},
    {".3mf", Content::Solid, "solid for printing: closed, with its unit",
     [](const Scene& scene) { return solid(scene, solid_3mf); }, Kind::Made},
    {".vtu", Content::Centrelines,
     "lines for ParaView, with displacements, rotations, section forces and stress of the first result",
     [](const Scene& scene) {
         return Written{vtu_text(beam_lines(scene.surface,
                                            scene.results.empty() ? nullptr : &scene.results.front().result,
                                            scene.known_strength(), scene.models))};
     }},
    {".obj", Content::Centrelines, "line elements, displaced by the first result",
     [](const Scene& scene) { return Written{obj_text(main_lines(scene))}; }},
    {".ply", Content::Centrelines, "vertices and edges, displaced by the first result",
     [](const Scene& scene) { return Written{ply_text(main_lines(scene))}; }},
    {".csv", Content::Centrelines, "table of nodes with displacements and rotations of the first result",
     [](const Scene& scene) { return Written{csv_text(main_lines(scene))}; }},
    {".svg", Content::Cut, "outline for cutting, as in .dxf",
     [](const Scene& scene) { return cut(scene, cut_svg); }, Kind::Made},
    {".obj", Content::Solid, "solid, as in .stl; millimetres",
     [](const Scene& scene) { return solid(scene, solid_obj); }, Kind::Made},
    {".ply", Content::Solid, "solid, as in .stl; millimetres",
     [](const Scene& scene) { return solid(scene, solid_ply); }, Kind::Made},
    {".3mf", Content::Centrelines, "beam lattice of round bars with the area of the rectangles",
     [](const Scene& scene) {
         return Written{lattice_3mf(fabrication::bar_plan(scene.surface, making(scene).frame_width))};
     },
     Kind::Made},
    {".txt", Content::Facts,
     "facts for making: mass, data of cutting and printing, narrow places, and the sag and the stresses "
     "under a load case; with warnings",
     [](const Scene& scene) { return Written{facts_text(scene_facts(scene))}; }, Kind::Made},
    {".json", Content::Facts, "the same facts for programs, in SI units",
     [](const Scene& scene) { return Written{facts_json(scene_facts(scene))}; }, Kind::Made},
    {".html", Content::Facts, "the same facts as a page, with a picture that marks the warnings",
     [](const Scene& scene) {
         return Written{
             facts_html({scene_facts(scene), fabrication::whole_sheet(scene.surface, making(scene))})};
     },
     Kind::Made},
}};

struct ContentName {
    Content content;
    std::string_view name;
};
constexpr std::array<ContentName, 5> kContents = {{{Content::Drawing, "drawing"},
                                                   {Content::Centrelines, "centrelines"},
                                                   {Content::Cut, "cut"},
                                                   {Content::Solid, "solid"},
                                                   {Content::Facts, "facts"}}};

}  // namespace

std::span<const WriterRow> writer_catalogue() {
    return kWriters;
}

bool is_default(const WriterRow& writer) {
    return &find_writer("file" + std::string(writer.ending)) == &writer;
}

std::string_view content_name(Content content) {
    return std::ranges::find(kContents, content, &ContentName::content)->name;
}

std::string_view unit_of(const WriterRow& writer) {
    if (writer.ending == ".png" || writer.ending == ".html") return "none";
    const bool is_in_millimetres = writer.ending == ".svg" || writer.ending == ".txt";
    return is_in_millimetres || !writer.shows_results() ? "millimetre" : "metre";
}

Content parse_content(const std::string& name) {
    return base::find_named(name, kContents, &ContentName::name, "content").content;
}

const WriterRow& find_writer(const std::filesystem::path& path, std::optional<Content> content) {
    const std::string ending = base::ending_of(path);
    std::vector<std::string> endings;
    std::vector<std::string> contents;
    for (const WriterRow& writer : kWriters) {
        if (writer.ending == ending) {
            if (!content || writer.content == *content) return writer;
            contents.emplace_back(content_name(writer.content));
        }
        if (std::ranges::find(endings, writer.ending) == endings.end()) endings.emplace_back(writer.ending);
    }
    if (!contents.empty())
        throw base::InputError(path.string(), "",
                               "cannot hold the content '" + std::string(content_name(*content)) + "'; " +
                                   ending + " holds: " + base::join(contents, ", "));
    throw base::InputError(path.string(), "", base::unknown_name_message("ending", ending, endings));
}

}  // namespace fretwork::exports
