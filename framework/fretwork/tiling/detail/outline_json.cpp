// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/json_reader.hpp>
#include <fretwork/tiling/detail/outline_readers.hpp>

namespace fretwork::tiling::detail {
namespace {

pattern::Polygon read_polygon(const base::JsonReader& json) {
    pattern::Polygon polygon;
    for (const base::JsonReader& point : json.elements()) {
        const std::vector<double> place = point.numbers(2);
        polygon.push_back({place[0], place[1]});
    }
    if (polygon.size() < 3)
        json.fail("has " + std::to_string(polygon.size()) + " points, where at least 3 are needed");
    return polygon;
}

}  // namespace

Outline read_json_outline(const std::filesystem::path& path) {
    const auto file = base::JsonReader::from_file(path);
    file.expect_format("outline");
    file.allow_only({"format", "boundary", "holes"});
    std::vector<pattern::Polygon> holes;
    if (const auto list = file.find("holes")) {
        for (const base::JsonReader& hole : list->elements()) holes.push_back(read_polygon(hole));
    }
    return make_outline(read_polygon(file.at("boundary")), std::move(holes));
}

}  // namespace fretwork::tiling::detail
