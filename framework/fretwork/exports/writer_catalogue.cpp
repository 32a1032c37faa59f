// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/line_files.hpp>
#include <fretwork/exports/picture.hpp>
#include <fretwork/exports/surface_drawing.hpp>
#include <fretwork/exports/view_page.hpp>
#include <fretwork/exports/writer_catalogue.hpp>

#include <array>

namespace fretwork::exports {
namespace {

LineSet main_lines(const Scene& scene) {
    return scene.results.empty() ? surface_lines(scene.surface)
                                 : result_lines(scene.surface, scene.results.front().result);
}

/// The paper's colours: the full model grey, the reduced one blue; more are told apart by the palette.
std::string layer_colour(std::size_t index) {
    constexpr std::array<const char*, 4> kColours = {"#8a8f94", "#2166ac", "#d6604d", "#1b7837"};
    return kColours[index % kColours.size()];
}

std::string svg_text(const Scene& scene) {
    DeformedViewOptions options;
    options.scale = scene.displacement_scale;
    if (scene.view) options.view = *scene.view;
    options.rest = rim_lines(scene.surface);
    options.labels = scene.labels;
    std::vector<DeformedLayer> layers;
    for (const Scene::LabelledResult& entry : scene.results) {
        layers.push_back(
            {entry.label, layer_colour(layers.size()), result_lines(scene.surface, entry.result)});
    }
    if (scene.conditions && layers.empty())
        return surface_svg(scene.surface, &*scene.conditions, scene.labels);
    if (scene.conditions) return figure_svg(scene.surface, *scene.conditions, layers, options);
    if (layers.empty()) return surface_svg(scene.surface, nullptr, scene.labels);
    return layers.size() == 1 ? displacement_svg(layers.front(), options) : deformed_svg(layers, options);
}

constexpr std::array<WriterRow, 7> kWriters = {{
    {".svg",
     "drawing: the surface from above; with one result its displacements in colour; with several, these over "
     "each other; with a load case and results all of it on one sheet",
     svg_text, WriterRow::Kind::Drawing},
    {".png",
     "picture: the bars as the first result bends them, lit and in perspective, on transparent ground; with "
     "a load case "
     "its supports",
     picture_png, WriterRow::Kind::Picture},
    {".html",
     "one page for any browser, without anything else: the same to turn, zoom, and see at rest or deformed",
     view_html, WriterRow::Kind::Picture},
    {".vtu",
     "lines for ParaView, with displacements, rotations, section forces and stress of the first result, and "
     "its load steps as a series in time",
     [](const Scene& scene) {
         return vtu_text(beam_lines(
             scene.surface, scene.results.empty() ? nullptr : &scene.results.front().result, scene.strength));
     }},
    {".obj", "line elements, displaced by the first result",
     [](const Scene& scene) { return obj_text(main_lines(scene)); }},
    {".ply", "vertices and edges, displaced by the first result",
     [](const Scene& scene) { return ply_text(main_lines(scene)); }},
    {".csv", "table of nodes with displacements and rotations of the first result",
     [](const Scene& scene) { return csv_text(main_lines(scene)); }},
}};

}  // namespace

std::span<const WriterRow> writer_catalogue() {
    return kWriters;
}

const WriterRow& find_writer(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    std::vector<std::string> endings;
    for (const WriterRow& writer : kWriters) {
        if (writer.ending == ending) return writer;
        endings.emplace_back(writer.ending);
    }
    throw base::InputError(path.string(), "", base::unknown_name_message("ending", ending, endings));
}

}  // namespace fretwork::exports
