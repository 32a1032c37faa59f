// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/tiling/detail/message_text.hpp>
#include <fretwork/tiling/detail/outline_readers.hpp>
#include <fretwork/tiling/detail/plane.hpp>
#include <fretwork/tiling/detail/svg_text.hpp>

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>

namespace fretwork::tiling::detail {
namespace {

constexpr int kDeepest = 256;  // of groups: no drawing needs more, and the reader's stack has an end
constexpr double kMetresPerPixel = 0.0254 / 96;
/// A curve that reaches farther out of the drawing than so many times its size is a slip.
constexpr double kFarthestOutside = 10;

/// What is never drawn by itself.
constexpr std::array<std::string_view, 16> kNotDrawn = {
    "defs", "title",          "desc",           "metadata", "style",  "script", "symbol", "clipPath",
    "mask", "linearGradient", "radialGradient", "pattern",  "marker", "filter", "view",   "cursor"};
constexpr std::array<std::string_view, 8> kShapes = {"path",   "polygon", "polyline", "rect",
                                                     "circle", "ellipse", "g",        "a"};

std::string line_of(std::string_view text, std::ptrdiff_t offset) {
    const auto end =
        text.begin() + std::clamp<std::ptrdiff_t>(offset, 0, static_cast<std::ptrdiff_t>(text.size()));
    return "line " + std::to_string(std::count(text.begin(), end, '\n') + 1);
}

class SvgReader {
  public:
    SvgReader(std::string source, std::string text) : source_(std::move(source)), text_(std::move(text)) {}

    std::vector<Loop> run() {
        pugi::xml_document document;
        const pugi::xml_parse_result parsed = document.load_buffer(text_.data(), text_.size());
        if (!parsed)
            throw base::InputError(source_, line_of(text_, parsed.offset),
                                   std::string("malformed XML: ") + parsed.description());
        const pugi::xml_node root = document.document_element();
        if (local_name(root) != "svg")
            throw base::InputError(source_, place(root),
                                   "the document is no SVG drawing: its root is not 'svg'");
        read_children(root, to_metres(root), 1);
        return std::move(loops_);
    }

  private:
    /// The name of an element without the prefix that some writers give to SVG's own namespace.
    static std::string_view local_name(pugi::xml_node node) {
        const std::string_view name = node.name();
        return name.starts_with("svg:") ? name.substr(4) : name;
    }

    /// "line 3, path 'rim'".
    [[nodiscard]] std::string place(pugi::xml_node node) const {
        const std::string id = node.attribute("id").value();
        return line_of(text_, node.offset_debug()) + ", " + std::string(local_name(node)) +
               (id.empty() ? "" : " '" + id + "'");
    }
    [[noreturn]] void fail(pugi::xml_node node, const std::string& message) const {
        throw base::InputError(source_, place(node), message);
    }

    /// Read an attribute, and put file and place before what its reader complains about.
    template <class Reader>
    auto read(pugi::xml_node node, const char* attribute, Reader reader) const {
        try {
            return reader(std::string_view(node.attribute(attribute).value()));
        } catch (const base::InputError& error) {
            fail(node, std::string(attribute) + ": " + error.what());
        }
    }
    [[nodiscard]] double length_or(pugi::xml_node node, const char* attribute, double missing) const {
        return node.attribute(attribute) ? read(node, attribute, parse_svg_length) : missing;
    }
    [[nodiscard]] double positive_length(pugi::xml_node node, const char* attribute) const {
        const double value = length_or(node, attribute, 0);
        if (!(value > 0))
            fail(node, std::string(attribute) + " is \"" + node.attribute(attribute).value() +
                           "\", where a length above zero is needed");
        return value;
    }

    /// From user units, y down, to metres, y up, with the origin at the lower left of the drawing.
    [[nodiscard]] Affine to_metres(pugi::xml_node root) {
        if (!root.attribute("width") || !root.attribute("height"))
            fail(root,
                 "width and height must say how large the drawing is, such as width=\"710mm\" "
                 "height=\"400mm\"");
        const double width = positive_length(root, "width");
        const double height = positive_length(root, "height");
        std::vector<double> box{0, 0, width, height};
        if (root.attribute("viewBox")) box = view_box(root);
        double scale_x = width / box[2];
        double scale_y = height / box[3];
        if (std::string_view(root.attribute("preserveAspectRatio").value()).find("none") ==
            std::string_view::npos)
            scale_x = scale_y = std::min(scale_x, scale_y);
        scale_x *= kMetresPerPixel;
        scale_y *= kMetresPerPixel;
        page_ = {scale_x * box[2], scale_y * box[3]};
        return {scale_x, 0, 0, -scale_y, -scale_x * box[0], scale_y * (box[1] + box[3])};
    }
    [[nodiscard]] std::vector<double> view_box(pugi::xml_node root) const {
        std::vector<double> box = read(root, "viewBox", [](std::string_view text) {
            SvgText walk(text);
            std::vector<double> numbers;
            while (!walk.at_end()) numbers.push_back(walk.number());
            return numbers;
        });
        if (box.size() != 4 || !(box[2] > 0) || !(box[3] > 0))
            fail(root, std::string("viewBox is \"") + root.attribute("viewBox").value() +
                           "\", where four numbers are needed, the last two above zero");
        return box;
    }

    static bool is_hidden(pugi::xml_node node) {
        std::string style = node.attribute("style").value();
        std::erase(style, ' ');
        return std::string_view(node.attribute("display").value()) == "none" ||
               style.find("display:none") != std::string::npos;
    }

    void read_children(pugi::xml_node parent, const Affine& map, int depth) {
        if (depth > kDeepest)
            fail(parent, "groups lie more than " + std::to_string(kDeepest) + " deep in one another");
        for (const pugi::xml_node node : parent.children()) {
            if (node.type() != pugi::node_element || is_hidden(node)) continue;
            const std::string_view name = local_name(node);
            const bool is_foreign = name.find(':') != std::string_view::npos;  // an editor's own notes
            if (is_foreign || std::find(kNotDrawn.begin(), kNotDrawn.end(), name) != kNotDrawn.end())
                continue;
            if (std::find(kShapes.begin(), kShapes.end(), name) == kShapes.end())
                fail(node,
                     "'" + std::string(name) +
                         "' is no outline; what counts is path, polygon, polyline, rect, circle, ellipse in "
                         "groups (turn other things into paths, or remove them)");
            Affine inner = map;
            if (node.attribute("transform")) inner = map.after(read(node, "transform", parse_svg_transform));
            if (name == "g" || name == "a")
                read_children(node, inner, depth + 1);
            else
                add(node, subpaths_of(node, name), inner);
        }
    }

    void add(pugi::xml_node node, const std::vector<Subpath>& subpaths, const Affine& map) {
        for (std::size_t i = 0; i < subpaths.size(); ++i) {
            const std::string where =
                place(node) + (subpaths.size() > 1 ? ", subpath " + std::to_string(i) : "");
            Polygon points = flatten(subpaths[i], map);
            check_on_page(points, where);
            const Point2 from = points.front();
            const Point2 to = points.back();
            if (!subpaths[i].is_closed && distance(from, to) > kClosingTolerance)
                throw base::InputError(source_, where,
                                       "the curve is not closed: it ends " +
                                           base::format_number(std::round(distance(from, to) * 1e7) / 1e4) +
                                           " mm from where it begins");
            loops_.push_back({std::move(points), where});
        }
    }

    void check_on_page(const Polygon& points, const std::string& where) const {
        for (const Point2& point : points) {
            const double outside_x = std::max(-point.x, point.x - page_.x);
            const double outside_y = std::max(-point.y, point.y - page_.y);
            if (outside_x <= kFarthestOutside * page_.x && outside_y <= kFarthestOutside * page_.y) continue;
            throw base::InputError(source_, where,
                                   "reaches " + place_text(point) + " m, far outside the drawing, which is " +
                                       metres(page_.x) + " wide and " + metres(page_.y) +
                                       " high; at most ten times that is taken: is a control point wrong?");
        }
    }

    [[nodiscard]] std::vector<Subpath> subpaths_of(pugi::xml_node node, std::string_view name) const {
        if (name == "path") return read(node, "d", parse_svg_path);
        if (name == "polygon" || name == "polyline") return polyline(node, name == "polygon");
        if (name == "rect") return {rectangle(node)};
        const bool is_circle = name == "circle";
        const double rx = positive_length(node, is_circle ? "r" : "rx");
        const double ry = is_circle ? rx : positive_length(node, "ry");
        const Point2 center{length_or(node, "cx", 0), length_or(node, "cy", 0)};
        return {{beziers_of(Arc{center, {Point2{rx, 0}, Point2{0, ry}}, 0, 2 * std::numbers::pi}), true}};
    }

    [[nodiscard]] std::vector<Subpath> polyline(pugi::xml_node node, bool is_closed) const {
        const std::vector<Point2> points = read(node, "points", parse_svg_points);
        if (points.size() < 3)
            fail(node,
                 "points has " + std::to_string(points.size()) + " points, where at least 3 are needed");
        Subpath subpath;
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            subpath.pieces.push_back(straight(points[i], points[i + 1]));
        subpath.is_closed = is_closed;
        return {subpath};
    }

    /// Rounded if it has rx or ry; one that is missing equals the other, and neither exceeds half the side.
    [[nodiscard]] Subpath rectangle(pugi::xml_node node) const {
        const double width = positive_length(node, "width");
        const double height = positive_length(node, "height");
        const double rx = std::clamp(length_or(node, "rx", length_or(node, "ry", 0)), 0.0, width / 2);
        const double ry = std::clamp(length_or(node, "ry", length_or(node, "rx", 0)), 0.0, height / 2);
        const double x = length_or(node, "x", 0);
        const double y = length_or(node, "y", 0);
        const std::array<Point2, 4> centers = {Point2{x + width - rx, y + height - ry},
                                               Point2{x + rx, y + height - ry}, Point2{x + rx, y + ry},
                                               Point2{x + width - rx, y + ry}};
        Subpath subpath{{}, true};
        for (std::size_t i = 0; i < 4; ++i) {
            const double quarter = std::numbers::pi / 2;
            const auto corner = beziers_of(
                Arc{centers[i], {Point2{rx, 0}, Point2{0, ry}}, quarter * static_cast<double>(i), quarter});
            if (i > 0) subpath.pieces.push_back(straight(subpath.pieces.back()[3], corner.front()[0]));
            subpath.pieces.insert(subpath.pieces.end(), corner.begin(), corner.end());
        }
        return subpath;
    }

    std::string source_;
    std::string text_;
    Point2 page_;  // width and height, metres
    std::vector<Loop> loops_;
};

}  // namespace

std::vector<Loop> read_svg_loops(const std::filesystem::path& path) {
    return SvgReader(path.string(), base::read_text_file(path)).run();
}

}  // namespace fretwork::tiling::detail
