// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/geometry/internal/message_text.hpp>
#include <fretwork/geometry/internal/segment_box.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/outlines/outline_check.hpp>
#include <fretwork/tiling/detail/small_parts.hpp>

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

/// The distance along the outline from which two stretches are different; also the length of a piece.
constexpr double kApart = 0.1;  // share of the tiles' side

/// A piece of a side of the outline.
struct Piece {
    std::size_t loop;
    double along;  // start of the piece, as a length along its loop
    Point2 from;
    Point2 to;
};

/// A loop's length, and the smallest length along the loop that separates two stretches.
struct LoopSize {
    double length = 0.0;
    double apart = 0.0;
};

/// A place where two stretches are near each other.
struct NearPlace {
    double width = 0.0;
    std::size_t loop = 0;
    double along = 0.0;
    Point2 place;
    friend bool operator<(const NearPlace& a, const NearPlace& b) {
        return std::tie(a.width, a.loop, a.along) < std::tie(b.width, b.loop, b.along);
    }
};

class NearPlaces {
  public:
    NearPlaces(const outlines::Outline& outline, double edge, const base::Control& control)
        : edge_(edge), control_(control) {
        add_loop(outline.boundary);
        for (const Polygon& hole : outline.holes) add_loop(hole);
    }

    /// The narrowest place, if it is narrower than kNarrowest allows.
    std::optional<NearPlace> narrowest() {
        using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const Piece*>;
        std::vector<Box> boxes;
        boxes.reserve(pieces_.size());
        const double reach = 0.5 * kNarrowest * edge_;
        for (const Piece& piece : pieces_) {
            boxes.emplace_back(geometry::box_around(piece.from, piece.to, reach), &piece);
        }
        CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
            control_.check();
            look_between(*a.handle(), *b.handle());
        });
        return narrowest_;
    }

  private:
    void add_loop(const Polygon& points) {
        double along = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            control_.check();
            const Point2 from = points[i];
            const Point2 to = points[(i + 1) % points.size()];
            const double side = distance(from, to);
            const auto count = static_cast<std::size_t>(std::ceil(side / (kApart * edge_)));
            for (std::size_t k = 0; k < count; ++k) {
                const double first = static_cast<double>(k) / static_cast<double>(count);
                const double last = static_cast<double>(k + 1) / static_cast<double>(count);
                pieces_.push_back(
                    {loops_.size(), along + first * side, between(from, to, first), between(from, to, last)});
            }
            along += side;
        }
        loops_.push_back({along, std::min(kApart * edge_, along / 4)});
    }

    /// Compare the nearest points of two segments that do not cross; one of these points is an end.
    void look_between(const Piece& a, const Piece& b) {
        for (const auto& [point, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
            note(*point, 0.0, *other);
            note(*point, distance(point->from, point->to), *other);
        }
    }
    void note(const Piece& piece, double along_piece, const Piece& other) {
        const Point2 point = along_piece > 0 ? piece.to : piece.from;
        const Point2 nearest = nearest_on_segment(other.from, other.to, point);
        const double along = piece.along + along_piece;
        // geometry::distance() would underflow, and the message would say 0.
        const double width = std::hypot(nearest.x - point.x, nearest.y - point.y);
        if (width >= kNarrowest * edge_) return;
        if (piece.loop == other.loop) {
            const LoopSize& loop = loops_[piece.loop];
            const double way = std::abs(other.along + distance(other.from, nearest) - along);
            if (std::min(way, loop.length - way) < loop.apart) return;
        }
        const NearPlace place{width, piece.loop, along, point};
        if (!narrowest_ || place < *narrowest_) narrowest_ = place;
    }

    double edge_;
    const base::Control& control_;
    std::vector<Piece> pieces_;
    std::vector<LoopSize> loops_;
    std::optional<NearPlace> narrowest_;
};

/// Remove the points too near to the point before them, or to the first point. Returns the number removed.
int remove_negligible_points(Polygon& points, double tolerance) {
    const std::size_t before = points.size();
    geometry::remove_repeated_points(points, tolerance);
    return static_cast<int>(before - points.size());
}

}  // namespace

CleanOutline without_negligible_points(const outlines::Outline& outline, double edge,
                                       const base::Control& control) {
    CleanOutline clean{outline, 0};
    clean.left_out = remove_negligible_points(clean.outline.boundary, kNegligibleShare * edge);
    std::vector<Polygon> loops{clean.outline.boundary};
    for (Polygon& hole : clean.outline.holes) {
        clean.left_out += remove_negligible_points(hole, kNegligibleShare * edge);
        loops.push_back(hole);
    }
    if (clean.left_out == 0) return clean;
    if (const auto flaw = outlines::outline_flaw(loops, control))
        throw base::GeometryError("points of the outline less than " +
                                  geometry::metres(kNegligibleShare * edge) +
                                  " apart count as one point for tiles with sides of " +
                                  geometry::metres(edge) + ", and with these points merged, " + *flaw);
    return clean;
}

void check_small_parts(const outlines::Outline& outline, double edge, const base::Control& control) {
    const auto place = NearPlaces(outline, edge, control).narrowest();
    if (!place) return;
    const std::string loop = place->loop == 0 ? "the boundary" : "hole " + std::to_string(place->loop - 1);
    const std::string width = place->width < 1e-15 ? "less than 1e-15 m" : geometry::metres(place->width);
    throw base::GeometryError(loop + " is " + width + " from another part of the outline near " +
                              place_text(place->place) + "; tiles with sides of " + geometry::metres(edge) +
                              " need " + geometry::metres(kNarrowest * edge) +
                              " at least: remove the needle or slit there, or make it wider");
}

}  // namespace fretwork::tiling::detail
