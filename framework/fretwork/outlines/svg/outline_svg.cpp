// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/outlines/svg/shown.hpp>
#include <fretwork/outlines/svg/svg_reader.hpp>

#include <algorithm>

namespace fretwork::outlines::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

/// Copy a clip, with the clips that it needs, to another picture. Returns the index of the copy.
std::size_t copy_clip(const Picture& from, std::size_t clip, Picture& to) {
    Clip made = from.clips[clip];
    if (made.outer) made.outer = copy_clip(from, *made.outer, to);
    for (FilledShape& shape : made.shapes)
        if (shape.clip) shape.clip = copy_clip(from, *shape.clip, to);
    to.clips.push_back(std::move(made));
    return to.clips.size() - 1;
}

}  // namespace

OutlineFile SvgReader::run() {
    read();
    Region region = filled_region(picture_, how_.tolerance);
    if (region.parts.empty()) {
        region = stroked_region();
    } else if (lines_ > 0) {
        remarks_.leave_out("unfilled line" + std::string(lines_ == 1 ? "" : "s"), lines_);
    }
    remarks_.add_changes(region, how_.tolerance);
    if (region.cover)
        remarks_.add(document_.place(places_[*region.cover]) +
                     ", covers all other shapes; if it is a background, take it out");
    return {std::move(region.parts), remarks_.list()};
}

ColouredPicture SvgReader::run_for_colours() {
    read();
    if (picture_.shapes.empty())
        throw base::GeometryError("nothing in it is filled, so that it has no colours" + left_out_text());
    return {std::move(picture_), std::move(colours_)};
}

Region SvgReader::stroked_region() {
    for (const auto& [node, around] : strokes_) add_stroke(node, around);
    const Enclosed enclosed = enclosed_by(lines_drawn_, how_.tolerance, remarks_);
    Region region = nested_region(enclosed.curves, how_.tolerance);
    if (region.parts.empty()) throw base::GeometryError(nothing_filled());
    std::size_t holes = 0;
    for (const Outline& part : region.parts) holes += part.holes.size();
    remarks_.add("nothing is filled: the closed lines are taken as " +
                 base::counted(region.parts.size(), "outline") + " with " + base::counted(holes, "hole"));
    if (!enclosed.open.empty())
        leave_out_open(lines_drawn_.open, enclosed.open,
                       document_.place(open_places_[longest_of(lines_drawn_.open, enclosed.open)]), remarks_);
    return region;
}

std::string SvgReader::nothing_filled() const {
    std::string message = "nothing in it is filled";
    const std::size_t lines = strokes_.size();
    if (lines > 0)
        message += (lines == 1 ? ", and its line is not closed"
                               : ", and none of its " + base::counted(lines, "line") + " is closed") +
                   std::string("; loose ends are joined up to ") +
                   roughly_in_millimetres(widest_gap(how_.tolerance)) + " mm";
    return message + left_out_text();
}

std::string SvgReader::left_out_text() const {
    const std::string left_out = remarks_.left_out();
    return left_out.empty() ? "" : " (" + left_out + ")";
}

void SvgReader::add_stroke(pugi::xml_node node, const Surroundings& around) {
    const SvgProperties properties(node, document_);
    const SvgElement element(node, properties, document_);
    for (const Subpath& subpath : element.subpaths(document_.name_of(node), around.measure)) {
        Polygon points = flatten(subpath, {around.map, how_.tolerance});
        if (!subpath.is_closed) {
            add_open_line(std::move(points), node, around.clip);
            continue;
        }
        geometry::remove_repeated_points(points, kClosingShare * how_.tolerance);
        if (points.size() < 3) continue;
        check_loops({points}, node);
        add_closed_line(std::move(points), node, around.clip);
    }
}

void SvgReader::add_open_line(Polygon points, pugi::xml_node node, std::optional<std::size_t> clip) {
    if (points.size() < 2 || perimeter(points) <= how_.tolerance) return;  // a dot
    // Construction lines that reach far outside are left out, and do not spoil the rest of the drawing.
    if (!std::ranges::all_of(points, [&](Point2 point) { return is_near_page(point); })) {
        count_points(points.size(), node);
        return remarks_.leave_out("open line that reaches far out of the drawing");
    }
    check_loops({points}, node);
    if (clip) count_clipping(static_cast<double>(points.size() * clip_points_[*clip]), node);
    if (!is_shown_whole(picture_, clip, points, how_.tolerance))
        return remarks_.leave_out("open line that a clip cuts or hides");
    lines_drawn_.open.push_back(std::move(points));
    open_places_.push_back(node);
}

void SvgReader::add_closed_line(Polygon points, pugi::xml_node node, std::optional<std::size_t> clip) {
    if (clip) count_clipping(static_cast<double>(points.size() * clip_points_[*clip]), node);
    Polygon line = points;
    line.push_back(points.front());
    if (!clip || is_shown_whole(picture_, clip, line, how_.tolerance)) {
        lines_drawn_.closed.push_back(std::move(points));
        return;
    }
    // The area inside the line, cut by the clip: exact arithmetic takes a thousand times as long.
    constexpr double kExact = 1000;
    count_clipping(kExact * static_cast<double>(points.size() + clip_points_[*clip]), node);
    Picture cut;
    cut.shapes.push_back({.loops = {std::move(points)}, .rule = FillRule::Evenodd, .clip = {}});
    cut.shapes.front().clip = copy_clip(picture_, *clip, cut);
    for (Outline& part : filled_region(cut, how_.tolerance).parts) {
        lines_drawn_.closed.push_back(std::move(part.boundary));
        std::ranges::move(part.holes, std::back_inserter(lines_drawn_.closed));
    }
}

OutlineFile read_svg_outlines(const std::filesystem::path& path) {
    return SvgReader(path).run();
}

ColouredPicture parse_svg_colours(std::string_view text, const std::string& source) {
    return SvgReader(std::string(text), source).run_for_colours();
}

}  // namespace fretwork::outlines::detail
