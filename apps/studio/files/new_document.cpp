// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/project/painting_recipe.hpp>
#include <studio/document/examples.hpp>
#include <studio/document/painting_request.hpp>
#include <studio/files/new_document.hpp>
#include <studio/server/sent_file.hpp>
#include <studio/solving/first_painting.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fretwork::studio {
namespace {

double width_of(const std::vector<geometry::Point2>& points) {
    const auto [left, right] = std::ranges::minmax(points, {}, &geometry::Point2::x);
    return right.x - left.x;
}

/// Adds what the tiling has changed in the drawing.
void add_remarks(const simulation::NewProject& made, std::vector<std::string>& remarks) {
    if (made.report.negligible_points > 0)
        remarks.push_back(std::to_string(made.report.negligible_points) +
                          (made.report.negligible_points == 1
                               ? " point of the outline that lies very close to another left out"
                               : " points of the outline that lie very close to others left out"));
    if (made.report.refined_share > 0.0)
        remarks.push_back(std::to_string(std::max(1L, std::lround(100 * made.report.refined_share))) +
                          " % of the tiles were refined to fit narrow regions");
}

void scale(tiling::Tessellation& tessellation, double factor) {
    const auto scale_all = [factor](auto& points) {
        for (geometry::Point2& point : points) point = {factor * point.x, factor * point.y};
    };
    scale_all(tessellation.vertices);
    scale_all(tessellation.interface_nodes);
}

/// Makes the project. A mesh's faces are read from its file, and scaled as its outline was.
simulation::NewProject make_from(const SentOutline& sent, const outlines::OutlineFile& file,
                                 simulation::NewProjectOptions options) {
    if (options.tiles == simulation::TilesFrom::Outline)
        return simulation::make_project(file.parts, options, nullptr);
    simulation::NewProject made = read_sent(sent.file, [&](const std::filesystem::path& path) {
        options.outline_name = path.string();
        return simulation::make_project(file.parts, options, nullptr);
    });
    const double drawn = width_of(made.project.tessellation.vertices);
    scale(made.project.tessellation, sent.width.value_or(drawn) / drawn);
    return made;
}

/// A choice of patterns that only the studio has; all others are those of the command line.
constexpr std::string_view kToBeMade = "made:one";

}  // namespace

NewRequest read_new(const base::JsonReader& json) {
    json.allow_only({"id", "do", "outline", "example", "tile_size", "tiles", "patterns", "palette",
                     "property", "range", "dither", "layout", "discard"});
    NewRequest wanted;
    if (const auto example = json.find("example")) {
        json.allow_only({"id", "do", "example", "discard"});
        wanted.example = example->string();
        return wanted;
    }
    wanted.outline = read_sent_outline(json.at("outline"));
    if (const auto layout = json.find("layout")) wanted.options.layout = read_name_or_path(*layout);
    const auto patterns = json.find("patterns");
    wanted.is_to_be_made = patterns && patterns->string() == kToBeMade;
    if (wanted.is_to_be_made)
        json.allow_only({"id", "do", "outline", "tile_size", "tiles", "patterns", "layout", "discard"});
    else
        wanted.options.painting = typed::read_painting(read_painting_text(json));
    const auto tiles = json.find("tiles");
    if (tiles && tiles->choice({"new", "faces"}) == "faces")
        wanted.options.tiles = simulation::TilesFrom::Mesh;
    if (const auto size = json.find("tile_size")) wanted.options.edge_length = size->positive_number();
    return wanted;
}

NamedProject make(const NewRequest& wanted, const base::Control& control) {
    if (!wanted.example.empty())
        return {example_title(wanted.example), make_example(wanted.example, control), {}, true};
    simulation::NewProjectOptions options = wanted.options;
    options.control = control;
    outlines::OutlineFile file = take_outline(wanted.outline).file;
    simulation::NewProject made = make_from(wanted.outline, file, options);
    add_remarks(made, file.remarks);
    if (const auto remark = simulation::unkept_file_remark(made.project, options.painting, made.painted))
        file.remarks.push_back(*remark);
    if (wanted.is_to_be_made) {
        const std::string remark = paint_to_be_made(made.project, control);
        if (!remark.empty()) file.remarks.push_back(remark);
    }
    return {std::filesystem::path(wanted.outline.file.name).stem().string(), std::move(made.project),
            std::move(file.remarks)};
}

}  // namespace fretwork::studio
