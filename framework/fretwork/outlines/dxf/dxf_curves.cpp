// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/outlines/dxf/dxf_curves.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::outlines::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFlat = 1e-6;  // largest slope of what lies flat, the precision of single-precision files

Point2 point(const DxfFile& file, const DxfEntity& entity, int code) {
    return {file.value(entity, code), file.value(entity, code + 10)};
}

/// The counterclockwise sweep from `start` to `end`, above zero and at most a whole turn.
double sweep_of(double start, double end) {
    const double sweep = std::fmod(end - start, kTurn);
    return sweep <= 0 ? sweep + kTurn : sweep;
}

DxfDrawn closed(Polygon points) {
    points.pop_back();  // equal to the first point
    return {DxfCurve{std::move(points), DxfCurve::Ends::Closed}, ""};
}

DxfDrawn draw_arc(const DxfFile& file, const DxfEntity& entity, const Flattening& how) {
    const double radius = file.value(entity, 40);
    if (radius < 0)
        file.fail(entity.line, std::string(entity.name) + " has the radius " + base::format_number(radius));
    if (radius == 0) return {std::nullopt, std::string(entity.name) + " of radius 0"};
    const Point2 center = point(file, entity, 10);
    const bool is_circle = entity.name == "CIRCLE";
    const double start = is_circle ? 0 : kDegree * file.value(entity, 50);
    const double sweep = is_circle ? kTurn : sweep_of(start, kDegree * file.value(entity, 51));
    Polygon points =
        flatten({beziers_of(Arc{center, {Point2{radius, 0}, Point2{0, radius}}, start, sweep}), false}, how);
    if (is_circle) return closed(std::move(points));
    return {DxfCurve{std::move(points), DxfCurve::Ends::Open}, ""};
}

/// Draw an ellipse. Its second axis is the first axis, shortened and turned to the left; seen from below, to
/// the right.
DxfDrawn draw_ellipse(const DxfFile& file, const DxfEntity& entity, const Flattening& how) {
    const Point2 major = point(file, entity, 11);
    const double ratio = file.value(entity, 40) * (file.value_or(entity, 230, 1) < 0 ? -1 : 1);
    if (!(length(major) > 0) || ratio == 0) file.fail(entity.line, "ELLIPSE has an axis without length");
    const Point2 minor = ratio * Point2{-major.y, major.x};
    const double start = file.value_or(entity, 41, 0);
    const double end = file.value_or(entity, 42, kTurn);
    constexpr double kRounding = 1e-6;  // rad, because files round 2 pi
    const double sweep = std::abs(std::abs(end - start) - kTurn) < kRounding ? kTurn : sweep_of(start, end);
    Polygon points =
        flatten({beziers_of(Arc{point(file, entity, 10), {major, minor}, start, sweep}), false}, how);
    if (sweep == kTurn) return closed(std::move(points));
    return {DxfCurve{std::move(points), DxfCurve::Ends::Open}, ""};
}

/// A vertex of a polyline. The side after the vertex is an arc, unless `bulge` is 0. `bulge` is the tangent
/// of a quarter of the arc's angle.
struct Vertex {
    Point2 place;
    double bulge = 0.0;
};

/// Check the number of vertices, which group 90 states.
void check_count(const DxfFile& file, const DxfEntity& entity, std::size_t vertices) {
    const DxfGroup* group = file.find(entity, 90);
    if (!group || file.whole_number(*group) == static_cast<long>(vertices)) return;
    file.fail(group->line + 1, std::string(entity.name) + " promises " + std::string(group->value) +
                                   " vertices, and has " + std::to_string(vertices));
}

std::vector<Vertex> light_vertices(const DxfFile& file, const DxfEntity& entity) {
    std::vector<Vertex> vertices;
    for (const DxfGroup& group : entity.groups) {
        if (group.code == 10) vertices.push_back({{file.number(group), 0}, 0});
        if (vertices.empty()) continue;
        if (group.code == 20) vertices.back().place.y = file.number(group);
        if (group.code == 42) vertices.back().bulge = file.number(group);
    }
    check_count(file, entity, vertices.size());
    return vertices;
}

/// True for a vertex that is a control point of a curve on which the other vertices of its polyline lie.
bool is_control_point(const DxfFile& file, const DxfEntity& vertex) {
    return (file.whole_or(vertex, 70, 0) & 16L) != 0;
}

/// The vertices of an old-style polyline, without control points.
std::vector<Vertex> heavy_vertices(const DxfFile& file, std::span<const DxfEntity> from) {
    std::vector<Vertex> vertices;
    for (std::size_t i = 1; i < from.size() && from[i].name == "VERTEX"; ++i)
        if (!is_control_point(file, from[i]))
            vertices.push_back({point(file, from[i], 10), file.value_or(from[i], 42, 0)});
    return vertices;
}

void add_side(const Vertex& from, Point2 to, std::vector<Bezier>& pieces) {
    if (from.place == to) return;
    if (from.bulge == 0) return pieces.push_back(straight(from.place, to));
    const double sweep = 4 * std::atan(from.bulge);
    const Point2 chord = to - from.place;
    const Point2 left{-chord.y, chord.x};
    const Point2 center = between(from.place, to, 0.5) + (0.5 / std::tan(sweep / 2)) * left;
    const Point2 radius = from.place - center;
    std::vector<Bezier> arc = beziers_of(Arc{center, {radius, Point2{-radius.y, radius.x}}, 0, sweep});
    arc.front()[0] = from.place;
    arc.back()[3] = to;
    pieces.insert(pieces.end(), arc.begin(), arc.end());
}

/// The polygon of a chain of pieces, flattened one by one, because each may have very many points. One more
/// point than `most` may be the first point again.
Polygon flatten_chain(const std::vector<Bezier>& pieces, const DxfFlattening& how) {
    Polygon points;
    for (const Bezier& piece : pieces) {
        if (points.size() > how.most + 1) break;
        const Polygon next = flatten({{piece}, false}, how);
        points.insert(points.end(), next.begin() + (points.empty() ? 0 : 1), next.end());
    }
    return points;
}

DxfDrawn draw_polyline(const DxfFile& file, const DxfEntity& entity, const std::vector<Vertex>& vertices,
                       const DxfFlattening& how) {
    if (vertices.size() < 2) return {std::nullopt, std::string(entity.name) + " of less than two points"};
    const bool is_closed = (file.whole_or(entity, 70, 0) & 1L) != 0;
    std::vector<Bezier> pieces;
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
        add_side(vertices[i], vertices[i + 1].place, pieces);
    if (is_closed) add_side(vertices.back(), vertices.front().place, pieces);
    if (pieces.empty()) return {std::nullopt, std::string(entity.name) + " of less than two points"};
    Polygon points = flatten_chain(pieces, how);
    if (is_closed) return closed(std::move(points));
    return {DxfCurve{std::move(points), DxfCurve::Ends::Open}, ""};
}

DxfDrawn draw_heavy_polyline(const DxfFile& file, std::span<const DxfEntity> from, const DxfFlattening& how) {
    constexpr long kMesh = 16 | 64;
    if ((file.whole_or(from.front(), 70, 0) & kMesh) != 0) return {std::nullopt, "POLYLINE that is a mesh"};
    return draw_polyline(file, from.front(), heavy_vertices(file, from), how);
}

/// A coordinate of all points of a curve whose points each have their own z; for an ellipse, of the ends of
/// its longer axis, relative to the center; nothing for other entities. `code`: 10 for x, 20 for y, 30 for z.
std::vector<double> coordinates_in_space(const DxfFile& file, std::span<const DxfEntity> from, int code) {
    constexpr long kPolylineInSpace = 8;
    const DxfEntity& entity = from.front();
    if (entity.name == "LINE") return {file.value_or(entity, code, 0), file.value_or(entity, code + 1, 0)};
    if (entity.name == "ELLIPSE") {
        const double end = file.value_or(entity, code + 1, 0);
        return {-end, end};
    }
    std::vector<double> found;
    if (entity.name == "SPLINE")
        for (const DxfGroup& group : entity.groups)
            if (group.code == code) found.push_back(file.number(group));
    if (entity.name == "POLYLINE" && (file.whole_or(entity, 70, 0) & kPolylineInSpace) != 0)
        for (std::size_t i = 1; i < from.size() && from[i].name == "VERTEX"; ++i)
            if (!is_control_point(file, from[i])) found.push_back(file.value_or(from[i], code, 0));
    return found;
}

/// True if z differs along the curve by more than rounding and the tolerance, so that the curve in the
/// drawing's plane would have another size.
bool is_tilted(const DxfFile& file, std::span<const DxfEntity> from, const Flattening& how) {
    const auto range = [&](int code) {
        const std::vector<double> values = coordinates_in_space(file, from, code);
        if (values.empty()) return 0.0;
        const auto [low, high] = std::ranges::minmax(values);
        return high - low;
    };
    const double rise = range(30);
    const Affine& map = how.to_metres;
    const double scale = std::sqrt(std::abs(map.a * map.d - map.b * map.c));
    return rise > kFlat * std::max(range(10), range(20)) && rise * scale > how.tolerance;
}

DxfDrawn not_flat(std::string_view name) {
    return {std::nullopt, std::string(name) + " that does not lie flat"};
}

/// True for entities whose coordinates are the drawing's coordinates, whatever their extrusion.
bool is_in_world_coordinates(std::string_view name) {
    return name == "LINE" || name == "ELLIPSE" || name == "SPLINE";
}

}  // namespace

std::optional<Affine> dxf_orientation(const DxfFile& file, const DxfEntity& entity) {
    if (std::abs(file.value_or(entity, 210, 0)) > kFlat || std::abs(file.value_or(entity, 220, 0)) > kFlat)
        return std::nullopt;
    return file.value_or(entity, 230, 1) < 0 ? Affine{-1, 0, 0, 1, 0, 0} : Affine{};
}

DxfDrawn draw_dxf_entity(const DxfFile& file, std::span<const DxfEntity> from, const DxfFlattening& given) {
    const DxfEntity& entity = from.front();
    const std::string_view name = entity.name;
    if (name == "VERTEX" || name == "SEQEND" || name == "POINT") return {};
    if (is_tilted(file, from, given)) return not_flat(name);
    DxfFlattening how = given;
    if (name == "LINE") {
        Polygon points = flatten({{straight(point(file, entity, 10), point(file, entity, 11))}, false}, how);
        return {DxfCurve{std::move(points), DxfCurve::Ends::Open}, ""};
    }
    const auto orientation = dxf_orientation(file, entity);
    if (!orientation) return not_flat(name);
    if (!is_in_world_coordinates(name)) how.to_metres = given.to_metres.after(*orientation);
    if (name == "CIRCLE" || name == "ARC") return draw_arc(file, entity, how);
    if (name == "ELLIPSE") return draw_ellipse(file, entity, how);
    if (name == "LWPOLYLINE") return draw_polyline(file, entity, light_vertices(file, entity), how);
    if (name == "POLYLINE") return draw_heavy_polyline(file, from, how);
    if (name == "SPLINE") {
        if (!file.find(entity, 10)) return {std::nullopt, "SPLINE without control points"};
        Polygon points = draw_dxf_spline(file, entity, how);
        if (points.empty()) return {std::nullopt, "SPLINE of equal knots"};
        return {DxfCurve{std::move(points), DxfCurve::Ends::Open}, ""};
    }
    return {std::nullopt, std::string(name)};
}

}  // namespace fretwork::outlines::detail
