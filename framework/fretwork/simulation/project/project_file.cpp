// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/base64.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/outlines/coloured_drawing.hpp>
#include <fretwork/pattern/internal/layout_json.hpp>
#include <fretwork/reduction/internal/setting_json.hpp>
#include <fretwork/simulation/internal/load_case_json.hpp>
#include <fretwork/simulation/internal/project_json.hpp>
#include <fretwork/simulation/load_cases/combination.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <fretwork/tiling/painting/field.hpp>
#include <fretwork/tiling/tessellation.hpp>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <utility>

namespace fretwork::simulation {
namespace {

using base::Json;
using base::JsonReader;
using geometry::Point2;
using tiling::Tessellation;
using tiling::Tile;

constexpr long long kMostOfAKind = 100'000'000;

std::vector<Point2> read_points(const JsonReader& json) {
    std::vector<Point2> points;
    for (const JsonReader& element : json.elements()) {
        const std::vector<double> place = element.numbers(2);
        points.push_back({place[0], place[1]});
    }
    return points;
}

Json points_json(const std::vector<Point2>& points) {
    Json list = Json::array();
    for (const Point2& point : points) list.push_back({point.x, point.y});
    return list;
}

template <class Index>
std::vector<Index> read_indices(const JsonReader& json) {
    std::vector<Index> indices;
    for (const JsonReader& element : json.elements()) indices.emplace_back(element.integer(0, kMostOfAKind));
    return indices;
}

template <class Index>
Json indices_json(const std::vector<Index>& indices) {
    Json list = Json::array();
    for (const Index index : indices) list.push_back(index.value);
    return list;
}

Tile read_tile(const JsonReader& json) {
    json.allow_only({"vertices", "interface_nodes", "pattern"});
    return {read_indices<tiling::VertexIndex>(json.at("vertices")),
            read_indices<tiling::InterfaceIndex>(json.at("interface_nodes")),
            static_cast<int>(json.at("pattern").integer(-1, kMostOfAKind))};
}

Json tile_json(const Tile& tile) {
    return {{"vertices", indices_json(tile.vertices)},
            {"interface_nodes", indices_json(tile.interface_nodes)},
            {"pattern", tile.pattern}};
}

pattern::NamedPattern read_pattern(const JsonReader& id, const pattern::NodeLayout& layout) {
    const std::string text = id.string();
    return id.located([&] { return pattern::parse_named_pattern(layout, text); });
}

Tessellation read_tessellation(const JsonReader& json, const pattern::NodeLayout& layout) {
    json.allow_only({"vertices", "interface_nodes", "tiles", "patterns"});
    Tessellation tessellation;
    tessellation.layout = layout.name();
    tessellation.vertices = read_points(json.at("vertices"));
    tessellation.interface_nodes = read_points(json.at("interface_nodes"));
    for (const JsonReader& tile : json.at("tiles").elements()) tessellation.tiles.push_back(read_tile(tile));
    for (const JsonReader& id : json.at("patterns").elements())
        tessellation.patterns.push_back(read_pattern(id, layout));
    return tessellation;
}

Json tessellation_json(const Tessellation& tessellation) {
    Json json;
    json["patterns"] = pattern::ids_of(tessellation.patterns);
    json["tiles"] = Json::array();
    for (const Tile& tile : tessellation.tiles) json["tiles"].push_back(tile_json(tile));
    json["vertices"] = points_json(tessellation.vertices);
    json["interface_nodes"] = points_json(tessellation.interface_nodes);
    return json;
}

outlines::Outline read_part_json(const JsonReader& json) {
    std::vector<geometry::Polygon> holes;
    for (const JsonReader& hole : json.at("holes").elements()) holes.push_back(read_points(hole));
    geometry::Polygon boundary = read_points(json.at("boundary"));
    return json.located<base::GeometryError>(
        [&] { return outlines::make_outline(std::move(boundary), std::move(holes)); });
}

/// The outlines of all parts. The first one has the same keys as the outline of a single part.
std::vector<outlines::Outline> read_outlines_json(const JsonReader& json) {
    json.allow_only({"boundary", "holes", "further_parts"});
    std::vector<outlines::Outline> outlines{read_part_json(json)};
    if (const auto further = json.find("further_parts")) {
        for (const JsonReader& part : further->elements()) {
            part.allow_only({"boundary", "holes"});
            outlines.push_back(read_part_json(part));
        }
    }
    return outlines;
}

Json part_json(const outlines::Outline& outline) {
    Json json;
    json["boundary"] = points_json(outline.boundary);
    json["holes"] = Json::array();
    for (const geometry::Polygon& hole : outline.holes) json["holes"].push_back(points_json(hole));
    return json;
}

Json outlines_json(const Project& project) {
    Json json = part_json(project.outline);
    for (const outlines::Outline& part : project.further_outlines)
        json["further_parts"].push_back(part_json(part));
    return json;
}

void read_library_link(const JsonReader& json, Project& project) {
    json.allow_only({"path", "hash"});
    project.library_path = json.at("path").string();
    project.library_hash = json.at("hash").string();
}

void read_load_cases(const JsonReader& json, Project& project) {
    const auto elements = json.elements();
    for (const JsonReader& element : elements) {
        LoadCase load_case = read_load_case(element);
        for (const LoadCase& other : project.load_cases) {
            if (other.name == load_case.name)
                element.at("name").fail("'" + other.name + "' is the name of two load cases");
        }
        project.load_cases.push_back(std::move(load_case));
    }
    for (std::size_t i = 0; i < elements.size(); ++i)
        elements[i].located([&] { check_combination(project.load_cases[i], project.load_cases); });
}

void read_tile_models(const JsonReader& json, Project& project) {
    std::vector<bool> is_chosen(project.tessellation.tiles.size(), false);
    for (const JsonReader& element : json.elements()) {
        element.allow_only({"model", "tiles"});
        Project::TileModelChoice choice{element.at("model").string(), {}};
        for (const JsonReader& tile : element.at("tiles").elements()) {
            const long long last = std::ssize(is_chosen) - 1;
            choice.tiles.emplace_back(tile.integer(0, last));
            auto chosen = is_chosen[choice.tiles.back()];
            if (chosen) tile.fail("is a tile for which a model is chosen twice");
            chosen = true;
        }
        project.tile_models.push_back(std::move(choice));
    }
}

// ---- recipes of the painting ----

FileContent read_content(const JsonReader& file) {
    file.allow_only({"name", "content_base64"});
    const JsonReader content = file.at("content_base64");
    return content.located([&] { return FileContent{base::decode_base64(content.string(), "")}; });
}

Json content_json(const std::filesystem::path& name, const std::optional<FileContent>& content) {
    return {{"name", name.string()},
            {"content_base64", base::encode_base64(content.value_or(FileContent{}).bytes)}};
}

PaletteChoice read_palette(const JsonReader& json, const pattern::NodeLayout& layout) {
    PaletteChoice palette;
    for (const JsonReader& id : json.elements()) palette.ids.push_back(read_pattern(id, layout).id);
    if (palette.ids.empty()) json.fail("is empty, where at least one pattern is needed");
    return palette;
}

PaintAtRandom read_random(const JsonReader& json, const pattern::NodeLayout& layout) {
    json.allow_only({"random", "palette", "weights", "tiles"});
    const JsonReader seed = json.at("random");
    const auto number = base::read_number<std::uint64_t>(seed.string());
    if (!number) seed.fail("is " + seed.text() + ", where a whole number as a text is needed");
    PaintAtRandom choice{.seed = *number, .palette = read_palette(json.at("palette"), layout)};
    if (const auto weights = json.find("weights")) {
        for (const JsonReader& weight : weights->elements(choice.palette.ids.size()))
            choice.weights.push_back(weight.positive_number());
    }
    return choice;
}

PaintByField read_field(const JsonReader& json, const pattern::NodeLayout& layout) {
    json.allow_only({"field", "image", "palette", "property", "range", "dither", "tiles"});
    PaintByField choice;
    if (const auto field = json.find("field")) {
        choice.field = FieldExpression{field->string()};
        field->located([&] { (void)tiling::expression_values(field->string(), {}, {}); });
    }
    if (const auto image = json.find("image"))
        choice.field = FieldImage{image->at("name").string(), read_content(*image)};
    choice.palette = read_palette(json.at("palette"), layout);
    if (const auto property = json.find("property")) choice.property = property->string();
    if (const auto range = json.find("range")) {
        if (choice.property.empty()) range->fail("is a range of the property, which is not given");
        const std::vector<double> ends = range->numbers(2);
        choice.range = std::pair(ends[0], ends[1]);
    }
    if (const auto dither = json.find("dither"); dither && dither->boolean())
        choice.dithering = tiling::Dithering::ErrorDiffusion;
    return choice;
}

PaintByColours read_colours(const JsonReader& json, const pattern::NodeLayout& layout) {
    json.allow_only({"drawing", "colours", "tiles"});
    const JsonReader drawing = json.at("drawing");
    PaintByColours choice{drawing.at("name").string(), {}, read_content(drawing)};
    for (const JsonReader& pair : json.at("colours").elements()) {
        const auto parts = pair.elements(2);
        const std::string colour = parts[0].string();
        choice.palette.emplace_back(parts[0].located([&] { return outlines::parse_colour(colour); }),
                                    read_pattern(parts[1], layout).id);
    }
    if (choice.palette.empty()) json.at("colours").fail("is empty, where at least one colour is needed");
    return choice;
}

PaintingChoice read_recipe_choice(const JsonReader& json, const pattern::NodeLayout& layout) {
    const bool is_random = json.find("random").has_value();
    const bool is_coloured = json.find("drawing").has_value();
    if (json.find("field").has_value() + json.find("image").has_value() + is_random + is_coloured != 1)
        json.fail("must paint by exactly one of field, image, drawing, random");
    if (is_random) return read_random(json, layout);
    if (is_coloured) return read_colours(json, layout);
    return read_field(json, layout);
}

void read_recipes(const JsonReader& json, Project& project) {
    std::vector<bool> has_recipe(project.tessellation.tiles.size(), false);
    for (const JsonReader& element : json.elements()) {
        PaintingRecipe recipe{read_recipe_choice(element, project.layout), {}};
        for (const JsonReader& number : element.at("tiles").elements()) {
            const tiling::TileIndex tile(number.integer(0, std::ssize(project.tessellation.tiles) - 1));
            if (has_recipe[tile]) number.fail("is a tile of two recipes");
            has_recipe[tile] = true;
            recipe.tiles.push_back(tile);
        }
        if (recipe.tiles.empty()) element.at("tiles").fail("is empty, where at least one tile is needed");
        std::ranges::sort(recipe.tiles);
        project.recipes.push_back(std::move(recipe));
    }
}

/// Adds the keys of a choice to a recipe.
struct ChoiceWriter {
    Json& json;

    void operator()(const PaintAtRandom& choice) const {
        json["random"] = std::to_string(choice.seed);
        json["palette"] = choice.palette.ids;
        if (!choice.weights.empty()) json["weights"] = choice.weights;
    }
    void operator()(const PaintByField& choice) const {
        if (const auto* field = std::get_if<FieldExpression>(&choice.field)) json["field"] = field->text;
        if (const auto* image = std::get_if<FieldImage>(&choice.field))
            json["image"] = content_json(image->file, image->content);
        json["palette"] = choice.palette.ids;
        if (!choice.property.empty()) json["property"] = choice.property;
        if (choice.range) json["range"] = {choice.range->first, choice.range->second};
        if (choice.dithering == tiling::Dithering::ErrorDiffusion) json["dither"] = true;
    }
    void operator()(const PaintByColours& choice) const {
        json["drawing"] = content_json(choice.drawing, choice.content);
        json["colours"] = Json::array();
        for (const auto& [colour, id] : choice.palette) json["colours"].push_back(Json::array({colour, id}));
    }
    /// Recipes have no other choices.
    template <class Other>
    void operator()(const Other&) const {
        assert(false);
    }
};

Json recipe_json(const PaintingRecipe& recipe) {
    Json json;
    std::visit(ChoiceWriter{json}, recipe.choice);
    json["tiles"] = indices_json(recipe.tiles);
    return json;
}

}  // namespace

Project read_project(const JsonReader& json) {
    json.expect_format("project", 4, 2);
    json.allow_only({"format", "layout", "setting", "library", "outline", "tessellation", "load_cases",
                     "tile_models", "recipes"});
    Project project;
    project.layout = pattern::read_node_layout(json.at("layout"));
    if (const auto setting = json.find("setting")) project.setting = reduction::read_setting(*setting);
    if (const auto library = json.find("library")) read_library_link(*library, project);
    auto outlines = read_outlines_json(json.at("outline"));
    project.outline = std::move(outlines.front());
    project.further_outlines.assign(std::make_move_iterator(outlines.begin() + 1),
                                    std::make_move_iterator(outlines.end()));
    project.tessellation = read_tessellation(json.at("tessellation"), project.layout);
    json.at("tessellation").located([&] { tiling::validate(project.tessellation, project.layout); });
    read_load_cases(json.at("load_cases"), project);
    if (const auto models = json.find("tile_models")) read_tile_models(*models, project);
    if (const auto recipes = json.find("recipes")) read_recipes(*recipes, project);
    if (!project.recipes.empty()) json.require_format("fretwork/project/4", "recipes");
    return project;
}

Project parse_project(std::string_view text, const std::string& source) {
    return read_project(JsonReader::from_text(text, source));
}

Project read_project(const std::filesystem::path& path) {
    return read_project(JsonReader::from_file(path));
}

std::string project_text(const Project& project) {
    Json json;
    // The oldest format that can express the project is written, for older programs.
    json["format"] = !project.recipes.empty()            ? "fretwork/project/4"
                     : !project.further_outlines.empty() ? "fretwork/project/3"
                                                         : "fretwork/project/2";
    json["layout"] = pattern::node_layout_json(project.layout);
    if (project.setting) json["setting"] = reduction::setting_json(*project.setting);
    if (!project.library_path.empty())
        json["library"] = {{"path", project.library_path}, {"hash", project.library_hash}};
    json["load_cases"] = Json::array();
    for (const LoadCase& load_case : project.load_cases)
        json["load_cases"].push_back(load_case_json(load_case));
    json["outline"] = outlines_json(project);
    json["tessellation"] = tessellation_json(project.tessellation);
    for (const Project::TileModelChoice& choice : project.tile_models)
        json["tile_models"].push_back({{"model", choice.model}, {"tiles", indices_json(choice.tiles)}});
    for (const PaintingRecipe& recipe : project.recipes) json["recipes"].push_back(recipe_json(recipe));
    return base::json_text(json);
}

void write_project(const Project& project, const std::filesystem::path& path) {
    base::write_file_atomically(path, project_text(project));
}

}  // namespace fretwork::simulation
