// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/tiling/detail/svg_reader.hpp>

namespace fretwork::tiling::detail {

OutlineFile SvgReader::run() {
    read();
    Region region = picture_.shapes.empty() ? stroked_region() : filled_region(picture_, how_.tolerance);
    if (region.parts.empty()) throw base::GeometryError(nothing_filled());
    remarks_.tell(region, how_.tolerance);
    if (region.cover)
        remarks_.say(document_.place(places_[*region.cover]) +
                     ", covers all other shapes; if it is a background, take it out");
    if (lines_ > 0) remarks_.leave_out("unfilled line" + std::string(lines_ == 1 ? "" : "s"), lines_);
    return {std::move(region.parts), remarks_.list()};
}

ColouredPicture SvgReader::run_for_colours() {
    read();
    if (picture_.shapes.empty()) throw base::GeometryError(nothing_filled());
    return {std::move(picture_), std::move(colours_)};
}

Region SvgReader::stroked_region() {
    for (const auto& [node, around] : lines_drawn_) add_stroked(node, around);
    Region region = nested_region(stroked_, how_.tolerance);
    if (region.parts.empty()) return region;
    std::size_t holes = 0;
    for (const Outline& part : region.parts) holes += part.holes.size();
    remarks_.say("nothing is filled: the closed lines are taken as " +
                 counted(static_cast<int>(region.parts.size()), "outline") + " with " +
                 counted(static_cast<int>(holes), "hole"));
    lines_ -= stroked_shapes_;
    return region;
}

std::string SvgReader::nothing_filled() const {
    std::string message = "nothing in it is filled";
    if (lines_ > 0) message += ", and none of its " + counted(lines_, "line") + " is closed";
    const std::string left_out = remarks_.left_out();
    return message + (left_out.empty() ? "" : " (" + left_out + ")");
}

void SvgReader::add_stroked(pugi::xml_node node, const Surroundings& around) {
    const SvgProperties properties(node, document_.rules());
    const SvgElement element(node, properties, document_);
    const std::string_view name = document_.name_of(node);
    std::vector<Subpath> closed;
    for (Subpath& subpath : element.subpaths(name, around.measure)) {
        if (!is_closed(subpath, around.map)) return;
        closed.push_back(std::move(subpath));
    }
    std::vector<Polygon> loops = loops_of(closed, around.map);
    if (loops.empty()) return;
    check_loops(loops, element.node());
    std::ranges::move(loops, std::back_inserter(stroked_));
    ++stroked_shapes_;
}

bool SvgReader::is_closed(const Subpath& subpath, const Affine& map) const {
    if (subpath.is_closed) return true;
    const Polygon points = flatten(subpath, {map, how_.tolerance});
    return points.size() > 3 && distance(points.front(), points.back()) <= how_.tolerance;
}

OutlineFile read_svg_outlines(const std::filesystem::path& path) {
    return SvgReader(path).run();
}

ColouredPicture read_svg_colours(const std::filesystem::path& path) {
    return SvgReader(path).run_for_colours();
}

}  // namespace fretwork::tiling::detail
