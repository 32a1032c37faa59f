// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/outlines/outline.hpp>

namespace fretwork::outlines {
namespace {

geometry::Polygon read_polygon(const base::JsonReader& json) {
    geometry::Polygon polygon;
    for (const base::JsonReader& point : json.elements()) {
        const std::vector<double> place = point.numbers(2);
        polygon.push_back({place[0], place[1]});
    }
    if (polygon.size() < 3)
        json.fail("has " + std::to_string(polygon.size()) + " points, where at least 3 are needed");
    return polygon;
}

base::Json polygon_json(const geometry::Polygon& polygon) {
    auto points = base::Json::array();
    for (const geometry::Point2& point : polygon) points.push_back({point.x, point.y});
    return points;
}

}  // namespace

Outline parse_outline(std::string_view text, const std::string& source) {
    const auto file = base::JsonReader::from_text(text, source);
    file.expect_format("outline");
    file.allow_only({"format", "boundary", "holes"});
    std::vector<geometry::Polygon> holes;
    if (const auto list = file.find("holes")) {
        for (const base::JsonReader& hole : list->elements()) holes.push_back(read_polygon(hole));
    }
    geometry::Polygon boundary = read_polygon(file.at("boundary"));
    return base::located<base::GeometryError>(
        source, "", [&] { return make_outline(std::move(boundary), std::move(holes)); });
}

std::string outline_text(const Outline& outline) {
    base::Json json;
    json["format"] = "fretwork/outline/1";
    json["boundary"] = polygon_json(outline.boundary);
    json["holes"] = base::Json::array();
    for (const geometry::Polygon& hole : outline.holes) json["holes"].push_back(polygon_json(hole));
    return base::json_text(json);
}

void write_outline(const Outline& outline, const std::filesystem::path& path) {
    base::write_file_atomically(path, outline_text(outline));
}

}  // namespace fretwork::outlines
