// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/outlines/detail/outline_readers.hpp>
#include <fretwork/outlines/regions/planar_map.hpp>

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace fretwork::outlines::detail {
namespace {

using Curve = SideTraits::Curve_2;
using Segment = CGAL::Arr_segment_traits_2<ExactKernel>::Curve_2;
using Face = PlanarMap::Face_handle;
using Halfedge = PlanarMap::Halfedge_handle;

int direction_of(const geometry::Point2& from, const geometry::Point2& to) {
    return from.x < to.x || (from.x == to.x && from.y < to.y) ? 1 : -1;
}

/// The halfedge, on the face's own side, through which a face is entered.
struct Entry {
    Face face;
    Halfedge through;
    enum class Event { Enter, Leave } event = Event::Enter;
};

class FaceWalk {
  public:
    FaceWalk(LineMap& lines, const WindingVisitor& visitor) : lines_(lines), visitor_(visitor) {
        for (auto face = lines.map.faces_begin(); face != lines.map.faces_end(); ++face)
            face->data().number = -1;
    }

    /// Visit faces depth first, so that each step back undoes the crossing of its step forward.
    void run() {
        enter(lines_.map.unbounded_face());
        while (!stack_.empty()) {
            const Entry entry = stack_.back();
            stack_.pop_back();
            if (entry.event == Entry::Event::Leave) {
                cross(entry.through, -1);
            } else if (entry.face->data().number < 0) {
                cross(entry.through, 1);
                stack_.push_back({entry.face, entry.through, Entry::Event::Leave});
                enter(entry.face);
            }
        }
    }

  private:
    void enter(Face face) {
        face->data().number = count_++;
        visitor_.look(face);
        for (const Halfedge halfedge : halfedges_of(face)) {
            const Face other = halfedge->twin()->face();
            if (other->data().number < 0) stack_.push_back({other, halfedge->twin()});
        }
    }
    /// Cross a halfedge from its right to its left, `sign` times.
    void cross(Halfedge halfedge, int sign) {
        const int along = halfedge->direction() == CGAL::ARR_LEFT_TO_RIGHT ? 1 : -1;
        for (const int side : halfedge->curve().data()) {
            const LineMap::Side& crossed = lines_.sides[side];
            visitor_.cross(crossed.line, sign * along * crossed.direction);
        }
    }

    LineMap& lines_;
    const WindingVisitor& visitor_;
    std::vector<Entry> stack_;
    int count_ = 0;
};

template <class Circulator>
void add_around(Circulator first, std::vector<Halfedge>& halfedges) {
    Circulator next = first;
    do {
        halfedges.push_back(next);
    } while (++next != first);
}

/// The largest number of crossings. Drawings of shapes have fewer, and more would take minutes.
constexpr std::size_t kMostCrossings = 100'000;

/// Twice the area of a triangle. Its sign may be wrong by rounding, which does not matter for a count.
double doubled_area(const geometry::Point2& a, const geometry::Point2& b, const geometry::Point2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

void check_crossings(const std::vector<std::array<geometry::Point2, 2>>& sides) {
    using Box =
        CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const std::array<geometry::Point2, 2>*>;
    std::vector<Box> boxes;
    boxes.reserve(sides.size());
    for (const auto& side : sides) {
        const auto [left, right] = std::minmax(side[0].x, side[1].x);
        const auto [low, high] = std::minmax(side[0].y, side[1].y);
        boxes.emplace_back(CGAL::Bbox_2(left, low, right, high), &side);
    }
    std::size_t near = 0;
    std::size_t crossings = 0;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
        const auto& [p, q] = *a.handle();
        const auto& [r, s] = *b.handle();
        const bool cross = doubled_area(p, q, r) * doubled_area(p, q, s) < 0 &&
                           doubled_area(r, s, p) * doubled_area(r, s, q) < 0;
        if (cross) ++crossings;
        if (++near > kMostNear || crossings > kMostCrossings)
            throw base::GeometryError("its curves cross more than " + std::to_string(kMostCrossings) +
                                      " times, or come near each other too often; that is not an outline");
    });
}

/// The sides of all lines, with equal sides stored once. Drawings contain the same shape many times, and
/// inserting equal segments takes time that grows with the square of their number.
class DrawnSides {
  public:
    void add(const geometry::Point2& from, const geometry::Point2& to, int side) {
        const auto [low, high] = direction_of(from, to) > 0 ? std::pair(from, to) : std::pair(to, from);
        const auto [known, is_new] = number_.try_emplace({low.x, low.y, high.x, high.y}, places_.size());
        if (is_new) {
            places_.push_back({from, to});
            sides_.emplace_back();
        }
        sides_[known->second].push_back(side);
    }
    [[nodiscard]] const std::vector<std::array<geometry::Point2, 2>>& places() const { return places_; }
    [[nodiscard]] std::vector<Curve> curves() const {
        std::vector<Curve> curves;
        curves.reserve(places_.size());
        std::map<std::array<double, 2>, ExactKernel::Point_2>
            exact;  // one object for each point, for a fast test of equality
        const auto exact_point = [&](const geometry::Point2& point) {
            return exact.try_emplace({point.x, point.y}, point.x, point.y).first->second;
        };
        for (std::size_t i = 0; i < places_.size(); ++i)
            curves.emplace_back(Segment(exact_point(places_[i][0]), exact_point(places_[i][1])), sides_[i]);
        return curves;
    }

  private:
    std::map<std::array<double, 4>, std::size_t> number_;
    std::vector<std::array<geometry::Point2, 2>> places_;
    std::vector<std::vector<int>> sides_;  ///< indices of the sides at each place
};

}  // namespace

LineMap make_line_map(const std::vector<MapLine>& lines) {
    LineMap made;
    DrawnSides drawn;
    for (std::size_t line = 0; line < lines.size(); ++line) {
        const geometry::Polygon& points = *lines[line].points;
        const bool is_closed = lines[line].ends == MapLine::Ends::Closed;
        const std::size_t count = points.empty() || is_closed ? points.size() : points.size() - 1;
        for (std::size_t i = 0; i < count; ++i) {
            const auto& [from, to] = std::pair(points[i], points[(i + 1) % points.size()]);
            if (from == to) continue;
            drawn.add(from, to, static_cast<int>(made.sides.size()));
            made.sides.push_back({static_cast<int>(line), direction_of(from, to)});
        }
    }
    check_crossings(drawn.places());
    const std::vector<Curve> curves = drawn.curves();
    CGAL::insert(made.map, curves.begin(), curves.end());
    return made;
}

void visit_faces(LineMap& lines, const WindingVisitor& visitor) {
    FaceWalk(lines, visitor).run();
}

std::vector<Halfedge> halfedges_of(Face face) {
    std::vector<Halfedge> halfedges;
    for (auto loop = face->outer_ccbs_begin(); loop != face->outer_ccbs_end(); ++loop)
        add_around(*loop, halfedges);
    for (auto loop = face->inner_ccbs_begin(); loop != face->inner_ccbs_end(); ++loop)
        add_around(*loop, halfedges);
    return halfedges;
}

}  // namespace fretwork::outlines::detail
