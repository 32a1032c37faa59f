// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/project/painting_recipe.hpp>
#include <studio/document/examples.hpp>
#include <studio/document/painting_request.hpp>
#include <studio/files/new_document.hpp>
#include <studio/server/sent_file.hpp>
#include <studio/server/sent_outline.hpp>
#include <studio/solving/first_painting.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace fretwork::studio {
namespace {

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

/// Makes the project. A mesh's faces are read from its file, and scaled as its outline was. Then they are
/// painted: fields and drawings are of the scaled places.
simulation::NewProject make_from(const SentOutline& sent, const TakenOutline& taken,
                                 simulation::NewProjectOptions options) {
    if (options.tiles == simulation::TilesFrom::Outline)
        return simulation::make_project(taken.file.parts, options, nullptr);
    const simulation::PaintingChoice painting = std::exchange(options.painting, {});
    simulation::NewProject made = read_sent(sent.file, [&](const std::filesystem::path& path) {
        options.outline_name = path.string();
        return simulation::make_project(taken.file.parts, options, nullptr);
    });
    scale(made.project.tessellation, taken.factor);
    made.painted = simulation::paint(made.project, painting, nullptr);
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
    TakenOutline taken = take_outline(wanted.outline);
    simulation::NewProject made = make_from(wanted.outline, taken, options);
    std::vector<std::string>& remarks = taken.file.remarks;
    add_remarks(made, remarks);
    if (const auto remark = simulation::unkept_file_remark(made.project, options.painting, made.painted))
        remarks.push_back(*remark);
    if (wanted.is_to_be_made) {
        const std::string remark = paint_to_be_made(made.project, control);
        if (!remark.empty()) remarks.push_back(remark);
    }
    return {std::filesystem::path(wanted.outline.file.name).stem().string(), std::move(made.project),
            std::move(remarks)};
}

}  // namespace fretwork::studio
