// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/file.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/tiling/detail/bezier.hpp>
#include <fretwork/tiling/detail/outline_readers.hpp>
#include <fretwork/tiling/detail/plane.hpp>

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>
#include <sstream>

namespace fretwork::tiling::detail {
namespace {

/// One pair of lines of an ASCII DXF file: a code that says what the value is.
struct Group {
    int code = 0;
    std::string value;
    int line = 0;  // of the code
};

/// An entity (or a vertex of one): its name and groups.
struct Entity {
    std::string name;
    int line = 0;
    std::vector<Group> groups;
};

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return "";
    return std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

/// A piece of a curve with two ends, in metres.
struct Piece {
    Polygon points;
    int line = 0;
};

class DxfReader {
  public:
    DxfReader(std::string source, const std::string& text) : source_(std::move(source)) {
        if (text.starts_with("AutoCAD Binary DXF"))
            throw base::InputError(source_, "", "is a binary DXF file, where an ASCII one is needed");
        std::istringstream stream(text);
        std::string code;
        std::string value;
        for (int line = 1; std::getline(stream, code); line += 2) {
            if (!std::getline(stream, value)) {
                if (trimmed(code).empty()) return;
                fail(line, "the file ends within a pair of code and value");
            }
            groups_.push_back({static_cast<int>(whole_number(trimmed(code), line)), trimmed(value), line});
        }
    }

    std::vector<Loop> run() {
        metres_per_unit_ = read_unit();
        const std::vector<Entity> entities = read_entities();
        for (std::size_t i = 0; i < entities.size(); ++i) read_entity(entities, i);
        join_pieces();
        return std::move(loops_);
    }

  private:
    [[noreturn]] void fail(int line, const std::string& message) const {
        throw base::InputError(source_, "line " + std::to_string(line), message);
    }
    [[nodiscard]] long whole_number(const std::string& text, int line) const {
        if (const auto value = base::read_number<long>(text)) return *value;
        fail(line, "'" + text + "' is no whole number; is this an ASCII DXF file?");
    }
    [[nodiscard]] double number(const Group& group) const {
        const auto value = base::read_number<double>(group.value);
        if (!value || !std::isfinite(*value))
            fail(group.line + 1, "'" + group.value + "' is no finite number");
        return *value;
    }

    [[nodiscard]] const Group* find(const Entity& entity, int code) const {
        const auto found = std::find_if(entity.groups.begin(), entity.groups.end(),
                                        [&](const Group& group) { return group.code == code; });
        return found == entity.groups.end() ? nullptr : &*found;
    }
    [[nodiscard]] double value(const Entity& entity, int code) const {
        const Group* group = find(entity, code);
        if (!group) fail(entity.line, entity.name + " has no group " + std::to_string(code));
        return number(*group);
    }
    [[nodiscard]] double value_or(const Entity& entity, int code, double missing) const {
        const Group* group = find(entity, code);
        return group ? number(*group) : missing;
    }
    [[nodiscard]] Point2 point(const Entity& entity, int code) const {
        return metres_per_unit_ * Point2{value(entity, code), value(entity, code + 10)};
    }

    /// $INSUNITS of the header; without it (or "unitless"), millimetres.
    [[nodiscard]] double read_unit() const {
        static const std::map<long, double> kUnits = {{0, 0.001}, {1, 0.0254}, {2, 0.3048}, {4, 0.001},
                                                      {5, 0.01},  {6, 1.0},    {14, 0.1}};
        for (std::size_t i = 0; i + 1 < groups_.size(); ++i) {
            if (groups_[i].code != 9 || groups_[i].value != "$INSUNITS") continue;
            const auto unit = kUnits.find(whole_number(groups_[i + 1].value, groups_[i + 1].line + 1));
            if (unit == kUnits.end())
                fail(groups_[i + 1].line + 1,
                     "$INSUNITS is " + groups_[i + 1].value +
                         ", where 1 (in), 2 (ft), 4 (mm), 5 (cm), 6 (m) or 14 (dm) is needed");
            return unit->second;
        }
        return 0.001;
    }

    /// What lies between "SECTION, ENTITIES" and "ENDSEC".
    [[nodiscard]] std::vector<Entity> read_entities() const {
        std::size_t i = 0;
        const auto begins_entities = [&](std::size_t at) {
            return groups_[at].code == 0 && groups_[at].value == "SECTION" && groups_[at + 1].code == 2 &&
                   groups_[at + 1].value == "ENTITIES";
        };
        while (i + 1 < groups_.size() && !begins_entities(i)) ++i;
        if (i + 1 >= groups_.size()) throw base::InputError(source_, "", "has no section ENTITIES");
        std::vector<Entity> entities;
        for (i += 2; i < groups_.size(); ++i) {
            const Group& group = groups_[i];
            if (group.code == 0 && group.value == "ENDSEC") return entities;
            if (group.code == 0) entities.push_back({group.value, group.line, {}});
            if (group.code != 0 && !entities.empty()) entities.back().groups.push_back(group);
        }
        throw base::InputError(source_, "", "the section ENTITIES has no end (ENDSEC)");
    }

    void read_entity(const std::vector<Entity>& entities, std::size_t i) {
        const Entity& entity = entities[i];
        check_flat(entity);
        if (entity.name == "LINE") {
            pieces_.push_back({{point(entity, 10), point(entity, 11)}, entity.line});
        } else if (entity.name == "CIRCLE") {
            add_loop(circle(entity, 0, 2 * std::numbers::pi), entity);
        } else if (entity.name == "ARC") {
            const double start = value(entity, 50) * std::numbers::pi / 180;
            double sweep = value(entity, 51) * std::numbers::pi / 180 - start;
            if (sweep <= 0) sweep += 2 * std::numbers::pi;
            pieces_.push_back({circle(entity, start, sweep), entity.line});
        } else if (entity.name == "LWPOLYLINE") {
            add_polyline(entity, light_vertices(entity));
        } else if (entity.name == "POLYLINE") {
            add_polyline(entity, heavy_vertices(entities, i));
        } else if (entity.name != "VERTEX" && entity.name != "SEQEND" && entity.name != "POINT") {
            fail(entity.line + 1,
                 "a " + entity.name +
                     " is no outline; what counts is LINE, ARC, CIRCLE, LWPOLYLINE and POLYLINE");
        }
    }

    /// Group 230 is the z of the direction out of the drawing: -1 would mirror it.
    void check_flat(const Entity& entity) const {
        if (const Group* out = find(entity, 230); out && number(*out) < 0)
            fail(out->line + 1,
                 entity.name + " is drawn from below (extrusion direction " + out->value + ")");
    }

    [[nodiscard]] Polygon circle(const Entity& entity, double start, double sweep) const {
        const double radius = metres_per_unit_ * value(entity, 40);
        if (!(radius > 0)) fail(entity.line, entity.name + " has the radius " + base::format_number(radius));
        return flatten(
            {beziers_of(Arc{point(entity, 10), {Point2{radius, 0}, Point2{0, radius}}, start, sweep}), false},
            Affine{});
    }

    /// A vertex of a polyline; the side behind it is an arc whose quarter angle has the tangent `bulge`.
    struct Vertex {
        Point2 place;
        double bulge = 0.0;
    };

    [[nodiscard]] std::vector<Vertex> light_vertices(const Entity& entity) const {
        std::vector<Vertex> vertices;
        for (const Group& group : entity.groups) {
            if (group.code == 10) vertices.push_back({{metres_per_unit_ * number(group), 0}, 0});
            if (vertices.empty()) continue;
            if (group.code == 20) vertices.back().place.y = metres_per_unit_ * number(group);
            if (group.code == 42) vertices.back().bulge = number(group);
        }
        check_count(entity, vertices.size());
        return vertices;
    }
    /// Group 90 says how many vertices there are.
    void check_count(const Entity& entity, std::size_t vertices) const {
        const Group* group = find(entity, 90);
        if (!group || whole_number(group->value, group->line + 1) == static_cast<long>(vertices)) return;
        fail(group->line + 1,
             entity.name + " promises " + group->value + " vertices, and has " + std::to_string(vertices));
    }
    [[nodiscard]] std::vector<Vertex> heavy_vertices(const std::vector<Entity>& entities,
                                                     std::size_t i) const {
        std::vector<Vertex> vertices;
        for (++i; i < entities.size() && entities[i].name == "VERTEX"; ++i)
            vertices.push_back({point(entities[i], 10), value_or(entities[i], 42, 0)});
        return vertices;
    }

    static void add_side(const Vertex& from, Point2 to, Polygon& points) {
        if (from.bulge == 0) {
            points.push_back(to);
            return;
        }
        const double sweep = 4 * std::atan(from.bulge);
        const Point2 chord = to - from.place;
        const Point2 left{-chord.y, chord.x};
        const Point2 center = between(from.place, to, 0.5) + (0.5 / std::tan(sweep / 2)) * left;
        const Point2 radius = from.place - center;
        const Polygon arc = flatten(
            {beziers_of(Arc{center, {radius, Point2{-radius.y, radius.x}}, 0, sweep}), false}, Affine{});
        points.insert(points.end(), arc.begin() + 1, arc.end() - 1);
        points.push_back(to);
    }

    [[nodiscard]] long flags_of(const Entity& entity) const {
        const Group* group = find(entity, 70);
        return group ? whole_number(group->value, group->line + 1) : 0;
    }

    void add_polyline(const Entity& entity, const std::vector<Vertex>& vertices) {
        if (vertices.size() < 2)
            fail(entity.line, entity.name + " has " + std::to_string(vertices.size()) + " vertices");
        const bool is_closed = (flags_of(entity) & 1L) != 0;
        Polygon points{vertices.front().place};
        for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
            add_side(vertices[i], vertices[i + 1].place, points);
        if (is_closed) {
            add_side(vertices.back(), vertices.front().place, points);
            add_loop(std::move(points), entity);
        } else {
            pieces_.push_back({std::move(points), entity.line});
        }
    }

    void add_loop(Polygon points, const Entity& entity) {
        loops_.push_back({std::move(points), entity.name + " at line " + std::to_string(entity.line)});
    }

    /// Chain lines, arcs and open polylines by their ends.
    void join_pieces() {
        std::vector<bool> used(pieces_.size(), false);
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (used[i]) continue;
            used[i] = true;
            Polygon points = pieces_[i].points;
            while (distance(points.front(), points.back()) > kJoiningTolerance || points.size() < 3) {
                const std::optional<std::size_t> next = piece_at(points.back(), used);
                if (!next) fail(pieces_[i].line, open_end_message(points));
                used[*next] = true;
                Polygon more = pieces_[*next].points;
                if (distance(points.back(), more.front()) > kJoiningTolerance)
                    std::reverse(more.begin(), more.end());
                points.insert(points.end(), more.begin() + 1, more.end());
            }
            points.pop_back();  // the first again, but for rounding
            loops_.push_back(
                {std::move(points), "the curve that begins at line " + std::to_string(pieces_[i].line)});
        }
    }
    [[nodiscard]] std::optional<std::size_t> piece_at(Point2 end, const std::vector<bool>& used) const {
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (!used[i] && (distance(pieces_[i].points.front(), end) <= kJoiningTolerance ||
                             distance(pieces_[i].points.back(), end) <= kJoiningTolerance))
                return i;
        }
        return std::nullopt;
    }
    [[nodiscard]] std::string open_end_message(const Polygon& points) const {
        const Point2 end = (1 / metres_per_unit_) * points.back();
        return "the curve that begins here is not closed: nothing goes on at (" + base::format_number(end.x) +
               ", " + base::format_number(end.y) + ")";
    }

    static constexpr double kJoiningTolerance = 1e-5;  // metres: drawings are rounded

    std::string source_;
    std::vector<Group> groups_;
    double metres_per_unit_ = 0.001;
    std::vector<Loop> loops_;
    std::vector<Piece> pieces_;
};

}  // namespace

std::vector<Loop> read_dxf_loops(const std::filesystem::path& path) {
    return DxfReader(path.string(), base::read_text_file(path)).run();
}

}  // namespace fretwork::tiling::detail
