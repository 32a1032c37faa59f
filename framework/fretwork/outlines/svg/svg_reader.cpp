// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/file.hpp>
#include <fretwork/geometry/internal/message_text.hpp>
#include <fretwork/outlines/svg/svg_reader.hpp>

#include <algorithm>
#include <array>

namespace fretwork::outlines::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

constexpr int kMostElements = 200'000;        // copies of copies grow fast
constexpr std::size_t kMostPoints = 200'000;  // points whose lines are tested for crossings
/// The distance by which a curve may leave the drawing, as a multiple of the drawing's size; a larger
/// distance is a slip.
constexpr double kFarthestOutside = 10;

/// The elements that are never drawn by themselves.
constexpr std::array<std::string_view, 21> kNotDrawn = {
    "defs",     "title",  "desc",           "metadata",         "style",         "script", "symbol",
    "clipPath", "mask",   "linearGradient", "radialGradient",   "pattern",       "marker", "filter",
    "view",     "cursor", "animate",        "animateTransform", "animateMotion", "set",    "solidColor"};
constexpr std::array<std::string_view, 6> kShapes = {"path", "polygon", "polyline",
                                                     "rect", "circle",  "ellipse"};

template <std::size_t n>
bool is_one_of(const std::array<std::string_view, n>& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

}  // namespace

SvgReader::SvgReader(const std::filesystem::path& path)
    : SvgReader(base::read_text_file(path), path.string()) {}
SvgReader::SvgReader(std::string text, std::string source)
    : source_(std::move(source)), document_(source_, std::move(text)) {}

void SvgReader::read() {
    const pugi::xml_node root = document_.root();
    page_ = page_of(root, document_, remarks_);
    how_.tolerance = flattening_tolerance(std::max(page_.width, page_.height));
    Surroundings all{.map = page_.to_metres, .measure = page_.measure};
    const SvgProperties properties(root, document_);
    all.style = style_in({}, properties, document_);
    if (!is_switched_off(properties)) read_children(root, all);
}

void SvgReader::read_children(pugi::xml_node parent, const Surroundings& around) {
    for (const pugi::xml_node node : parent.children()) {
        document_.charge(node, 1);  // what is not drawn is passed in every copy, too
        if (node.type() == pugi::node_element) read_element(node, around);
    }
}

void SvgReader::enter(pugi::xml_node node, int depth) {
    if (depth > kDeepest)
        document_.fail(node, "elements lie more than " + std::to_string(kDeepest) + " deep in one another");
    if (++elements_ > kMostElements)
        document_.fail(node,
                       "with all copies, more than " + std::to_string(kMostElements) + " elements are drawn");
}

void SvgReader::read_element(pugi::xml_node node, const Surroundings& outer) {
    const std::string_view name = document_.name_of(node);
    if (name.empty() || is_one_of(kNotDrawn, name) || !meets_conditions(node, document_)) return;
    enter(node, outer.depth);
    const SvgProperties properties(node, document_);
    if (properties.find("display") == "none") return;
    if (purpose_ == Purpose::Paint && is_switched_off(properties)) return;
    const SvgElement element(node, properties, document_);
    Surroundings around = outer;
    ++around.depth;
    around.style = style_in(outer.style, properties, document_);
    around.measure.font_size = around.style.font_size;
    around.map = outer.map.after(element.transform(outer.measure));
    around.clip = clip_of(element, around);
    for (const char* effect : {"mask", "filter"})
        if (const auto value = properties.find(effect);
            purpose_ == Purpose::Paint && !value.empty() && value != "none")
            remarks_.leave_out(std::string(effect) + " of an element");
    read_kind(name, element, around);
}

void SvgReader::read_kind(std::string_view name, const SvgElement& element, const Surroundings& around) {
    const bool is_group = name == "g" || name == "a" || name == "switch" || name == "svg";
    if (is_group && purpose_ == Purpose::Clip) return;  // a clip consists of shapes and copies of shapes
    if (name == "g" || name == "a") return read_children(element.node(), around);
    if (name == "switch") return read_switch(element.node(), around);
    if (name == "svg") return read_viewport(element, element, around);
    if (name == "use") return read_use(element, around);
    if (is_one_of(kShapes, name)) return read_shape(name, element, around);
    if (name == "line") {
        if (purpose_ == Purpose::Paint) remember_stroke(element.node(), around);
        return;
    }
    remarks_.leave_out(std::string(name));
}

void SvgReader::read_switch(pugi::xml_node parent, const Surroundings& around) {
    for (const pugi::xml_node node : parent.children()) {
        document_.charge(node, 1);
        if (node.type() == pugi::node_element && !document_.name_of(node).empty() &&
            meets_conditions(node, document_))
            return read_element(node, around);
    }
}

void SvgReader::read_viewport(const SvgElement& element, const SvgElement& sized, Surroundings around) {
    using Axis = SvgElement::Axis;
    const SvgMeasure& measure = around.measure;
    const auto size = [&](const char* name, Axis axis, double whole) {
        return sized.size_or(name, axis, measure, element.size_or(name, axis, measure, whole));
    };
    const bool is_svg = document_.name_of(element.node()) == "svg";
    const SvgBox box{is_svg ? element.length_or("x", Axis::X, measure, 0) : 0,
                     is_svg ? element.length_or("y", Axis::Y, measure, 0) : 0,
                     size("width", Axis::X, measure.width), size("height", Axis::Y, measure.height)};
    const auto view_box = element.view_box();
    if (!(box.width > 0) || !(box.height > 0)) return;
    if (view_box && (!((*view_box)[2] > 0) || !((*view_box)[3] > 0))) return;
    const std::string_view overflow = element.properties().find("overflow");
    if (overflow != "visible" && overflow != "auto")
        around.clip = add_clip({{{loops_of({box.outline()}, around.map)}}, around.clip}, element.node());
    around.map = around.map.after(
        view_box ? map_of_view_box(*view_box, box, element.node().attribute("preserveAspectRatio").value())
                 : Affine{1, 0, 0, 1, box.x, box.y});
    around.measure.width = view_box ? (*view_box)[2] : box.width;
    around.measure.height = view_box ? (*view_box)[3] : box.height;
    read_children(element.node(), around);
}

void SvgReader::read_use(const SvgElement& element, Surroundings around) {
    const pugi::xml_node node = element.node();
    const pugi::xml_attribute link =
        node.attribute("href") ? node.attribute("href") : node.attribute("xlink:href");
    const pugi::xml_node copied = document_.referred(link.value());
    if (!copied) return remarks_.leave_out("use of a missing element");
    if (std::ranges::find(copying_, copied) != copying_.end() ||
        node.attribute("id").value() == copied.attribute("id").value())
        document_.fail(node, "copies itself");
    const Affine moved{1,
                       0,
                       0,
                       1,
                       element.length_or("x", SvgElement::Axis::X, around.measure, 0),
                       element.length_or("y", SvgElement::Axis::Y, around.measure, 0)};
    around.map = around.map.after(moved);
    const std::string_view name = document_.name_of(copied);
    if (purpose_ == Purpose::Clip && !is_one_of(kShapes, name)) return;
    copying_.push_back(copied);
    if (name == "symbol" || name == "svg")
        read_copied_viewport(copied, element, around);
    else
        read_element(copied, around);
    copying_.pop_back();
}

void SvgReader::read_copied_viewport(pugi::xml_node copied, const SvgElement& use, Surroundings around) {
    const SvgProperties properties(copied, document_);
    if (is_switched_off(properties)) return;
    const SvgElement element(copied, properties, document_);
    around.style = style_in(around.style, properties, document_);
    around.map = around.map.after(element.transform(around.measure));
    around.clip = clip_of(element, around);
    ++around.depth;
    read_viewport(element, use, around);
}

void SvgReader::read_shape(std::string_view name, const SvgElement& element, const Surroundings& around) {
    const bool counts =
        purpose_ == Purpose::Box || (purpose_ == Purpose::Paint && around.style.is_filled()) ||
        (purpose_ == Purpose::Clip && around.style.visibility == SvgStyle::Visibility::Visible);
    if (purpose_ == Purpose::Paint) remember_stroke(element.node(), around);
    if (!counts) return;
    FilledShape shape{.loops = loops_of(element.subpaths(name, around.measure), around.map),
                      .rule = purpose_ == Purpose::Clip ? around.style.clip_rule : around.style.fill_rule,
                      .clip = around.clip};
    if (shape.loops.empty()) return;
    check_loops(shape.loops, element.node());
    shapes_->push_back(std::move(shape));
    if (purpose_ != Purpose::Paint) return;
    places_.push_back(element.node());
    colours_.push_back(around.style.fill_colour);
}

void SvgReader::remember_stroke(pugi::xml_node node, const Surroundings& around) {
    if (!around.style.is_stroked()) return;
    if (!around.style.is_filled() || document_.name_of(node) == "line") ++lines_;
    strokes_.emplace_back(node, around);
}

std::vector<Polygon> SvgReader::loops_of(const std::vector<Subpath>& subpaths, const Affine& map) const {
    std::vector<Polygon> loops;
    std::size_t all = points_;
    for (const Subpath& subpath : subpaths) {
        Polygon points = flatten(subpath, {map, how_.tolerance});
        geometry::remove_repeated_points(points, kClosingShare * how_.tolerance);
        if (points.size() < 3) continue;
        all += points.size();
        loops.push_back(std::move(points));
        if (all > kMostPoints) break;  // check_loops() refuses them; more would only take memory
    }
    return loops;
}

void SvgReader::count_points(std::size_t points, pugi::xml_node node) {
    points_ += points;
    if (points_ > kMostPoints)
        document_.fail(node, "up to here the drawing has more than " + std::to_string(kMostPoints) +
                                 " points, which is more than an outline can use; simplify its paths");
}

void SvgReader::check_loops(const std::vector<Polygon>& loops, pugi::xml_node node) {
    for (const Polygon& loop : loops) {
        count_points(loop.size(), node);
        for (const Point2& point : loop) {
            if (!std::isfinite(point.x) || !std::isfinite(point.y))
                document_.fail(node, "has a point that is not finite");
            if (purpose_ == Purpose::Paint) check_on_page(point, node);
        }
    }
}

bool SvgReader::is_near_page(Point2 point) const {
    const double outside_x = std::max(-point.x, point.x - page_.width);
    const double outside_y = std::max(-point.y, point.y - page_.height);
    return outside_x <= kFarthestOutside * page_.width && outside_y <= kFarthestOutside * page_.height;
}

void SvgReader::check_on_page(Point2 point, pugi::xml_node node) const {
    if (is_near_page(point)) return;
    document_.fail(node, "reaches " + place_text(point) + " m, far outside the drawing, which is " +
                             geometry::metres(page_.width) + " wide and " + geometry::metres(page_.height) +
                             " high; at most ten times that is taken: is a control point wrong?");
}

}  // namespace fretwork::outlines::detail
