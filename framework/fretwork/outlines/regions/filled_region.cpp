// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/outlines/regions/filled_region.hpp>
#include <fretwork/outlines/regions/map_parts.hpp>
#include <fretwork/outlines/regions/planar_map.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace fretwork::outlines::detail {
namespace {

using geometry::Polygon;

/// The largest number of curves that lie in one another, of which each pair is compared.
constexpr std::size_t kMostNested = 256;

bool is_inside(FillRule rule, int winding) {
    return rule == FillRule::Nonzero ? winding != 0 : winding % 2 != 0;
}

/// The shapes of a picture that contain the present face.
class OpenShapes {
  public:
    explicit OpenShapes(const Picture& picture) : picture_(picture), clipped_(picture.clips.size()) {
        for (const FilledShape& shape : picture.shapes) add(shape, std::nullopt);
        for (std::size_t clip = 0; clip < picture.clips.size(); ++clip) {
            for (const FilledShape& shape : picture.clips[clip].shapes) add(shape, clip);
        }
    }

    [[nodiscard]] const std::vector<MapLine>& lines() const { return lines_; }

    void cross(int line, int change) {
        const std::size_t shape = shape_of_line_[line];
        Member& member = members_[shape];
        const bool was_inside = is_inside(member.shape->rule, member.winding);
        member.winding += change;
        const bool is_now = is_inside(member.shape->rule, member.winding);
        if (was_inside == is_now) return;
        std::set<std::size_t>& open = member.clip ? clipped_[*member.clip] : filled_;
        is_now ? static_cast<void>(open.insert(shape)) : static_cast<void>(open.erase(shape));
    }
    [[nodiscard]] bool is_filled() const {
        return std::ranges::any_of(filled_, [&](std::size_t shape) { return is_visible(shape); });
    }
    [[nodiscard]] bool is_filled_by(std::size_t shape) const {
        return filled_.contains(shape) && is_visible(shape);
    }

  private:
    struct Member {
        const FilledShape* shape;
        // Clip to which the shape belongs; none: a shape that is filled itself.
        std::optional<std::size_t> clip;
        int winding = 0;
    };
    void add(const FilledShape& shape, std::optional<std::size_t> clip) {
        for (const Polygon& loop : shape.loops) {
            lines_.push_back({&loop});
            shape_of_line_.push_back(members_.size());
        }
        members_.push_back({&shape, clip});
    }
    [[nodiscard]] bool is_visible(std::size_t shape) const {
        const auto& clip = members_[shape].shape->clip;
        return !clip || is_open(*clip);
    }
    [[nodiscard]] bool is_open(std::size_t clip) const {
        constexpr std::size_t kMostLooks = 1'000'000'000;  // some ten seconds
        if (++looks_ > kMostLooks)
            throw base::GeometryError(
                "very many shapes lie in one another and in clips; release the clips in the drawing");
        const auto& outer = picture_.clips[clip].outer;
        return std::ranges::any_of(clipped_[clip], [&](std::size_t shape) { return is_visible(shape); }) &&
               (!outer || is_open(*outer));
    }

    const Picture& picture_;
    std::vector<Member> members_;
    std::vector<MapLine> lines_;
    std::vector<std::size_t> shape_of_line_;
    std::set<std::size_t> filled_;                // shapes of the picture that contain the face
    std::vector<std::set<std::size_t>> clipped_;  // for each clip, its shapes that contain the face
    mutable std::size_t looks_ = 0;               // clips that were looked at, for all faces
};

/// The shape with the largest box, the only shape that can cover all others.
std::size_t widest_shape(const Picture& picture) {
    std::size_t widest = 0;
    double most = -1;
    for (std::size_t shape = 0; shape < picture.shapes.size(); ++shape) {
        const geometry::Box box = box_of(picture.shapes[shape].loops);
        const double area = box.width() * box.height();
        if (area > most) {
            most = area;
            widest = shape;
        }
    }
    return widest;
}

/// The nesting of curves: A contains B if every face in B is also in A.
class Nesting {
  public:
    explicit Nesting(std::size_t curves) : winding_(curves, 0), around_(curves), depth_(curves, -1) {}

    void cross(int curve, int change) {
        int& winding = winding_[curve];
        const bool was_inside = winding != 0;
        winding += change;
        if (was_inside == (winding != 0)) return;
        if (was_inside)
            open_.erase(curve);
        else
            open_.insert(curve);
        if (open_.size() > kMostNested)
            throw base::GeometryError("more than " + std::to_string(kMostNested) +
                                      " closed curves lie in one another");
    }
    void look() {
        const std::vector<int> open(open_.begin(), open_.end());
        const std::vector<int> before = faces_.empty() ? std::vector<int>{} : faces_.back();
        std::vector<int> left;
        std::ranges::set_difference(before, open, std::back_inserter(left));
        for (const int curve : open) {
            auto& around = around_[curve];
            if (!around)
                around = open;
            else if (contains(before, curve))  // all that is around it is around the face before
                for (const int other : left) remove(*around, other);
            else
                std::erase_if(*around, [&](int other) { return !contains(open, other); });
        }
        faces_.push_back(open);
    }
    /// True if the innermost curve around a face lies in an even number of other curves.
    [[nodiscard]] bool is_filled(std::size_t face) const {
        int deepest = -1;
        for (const int curve : faces_[face]) deepest = std::max(deepest, depth(curve));
        return deepest >= 0 && deepest % 2 == 0;
    }

  private:
    // Numbers of curves, ascending.
    static bool contains(const std::vector<int>& curves, int curve) {
        return std::ranges::binary_search(curves, curve);
    }
    static void remove(std::vector<int>& curves, int curve) {
        const auto at = std::ranges::lower_bound(curves, curve);
        if (at != curves.end() && *at == curve) curves.erase(at);
    }
    /// The number of curves around a curve. Two curves that contain each other are one curve, drawn twice.
    [[nodiscard]] int depth(int curve) const {
        int& known = depth_[curve];
        if (known >= 0) return known;
        known = 0;
        for (const int other : *around_[curve])
            if (other != curve && !contains(*around_[other], curve))
                known = std::max(known, depth(other) + 1);
        return known;
    }

    std::vector<int> winding_;
    std::set<int> open_;
    std::vector<std::optional<std::vector<int>>> around_;  // for each curve, those open at each of its faces
    std::vector<std::vector<int>> faces_;                  // for each face, the open curves
    mutable std::vector<int> depth_;
};

/// The points of a curve, independent of its first point and its direction.
using Places = std::vector<std::array<double, 2>>;
Places places_of(const Polygon& curve) {
    const auto begun_at_the_least = [](Places places) {
        std::ranges::rotate(places, std::ranges::min_element(places));
        return places;
    };
    Places places;
    for (const geometry::Point2& point : curve) places.push_back({point.x, point.y});
    Places back(places.rbegin(), places.rend());
    return std::min(begun_at_the_least(std::move(places)), begun_at_the_least(std::move(back)));
}

/// The number of shapes with the same loops and the same rule as an earlier shape; clips are ignored.
int count_doubled(const std::vector<FilledShape>& shapes) {
    std::set<std::pair<std::vector<Places>, FillRule>> seen;
    int doubled = 0;
    for (const FilledShape& shape : shapes) {
        std::vector<Places> loops;
        for (const Polygon& loop : shape.loops) loops.push_back(places_of(loop));
        std::ranges::sort(loops);
        if (!seen.emplace(std::move(loops), shape.rule).second) ++doubled;
    }
    return doubled;
}

}  // namespace

Region filled_region(const Picture& picture, double tolerance) {
    if (picture.shapes.empty()) return {};
    OpenShapes open(picture);
    LineMap lines = make_line_map(open.lines());
    const std::size_t widest = widest_shape(picture);
    bool covers = picture.shapes.size() > 1;
    visit_faces(lines, {.cross = [&](int line, int change) { open.cross(line, change); },
                        .look =
                            [&](PlanarMap::Face_handle face) {
                                face->data().is_filled = open.is_filled();
                                covers = covers && (!open.is_filled() || open.is_filled_by(widest));
                            }});
    Region region = region_of_map(lines, tolerance);
    if (covers) region.cover = widest;
    region.doubled = count_doubled(picture.shapes);
    return region;
}

Region nested_region(const std::vector<Polygon>& curves, double tolerance) {
    std::vector<MapLine> closed;
    for (const Polygon& curve : curves) closed.push_back({&curve});
    LineMap lines = make_line_map(closed);
    Nesting nesting(curves.size());
    visit_faces(lines, {.cross = [&](int line, int change) { nesting.cross(line, change); },
                        .look = [&](PlanarMap::Face_handle) { nesting.look(); }});
    for (auto face = lines.map.faces_begin(); face != lines.map.faces_end(); ++face)
        face->data().is_filled = nesting.is_filled(face->data().number);
    return region_of_map(lines, tolerance);
}

Contours contours_of(const std::vector<Polygon>& polylines) {
    std::vector<MapLine> open;
    for (const Polygon& line : polylines) open.push_back({&line, MapLine::Ends::Open});
    LineMap lines = make_line_map(open);
    std::vector<PlanarMap::Halfedge_handle> bridges;
    std::vector<bool> encloses(polylines.size(), false);
    for (auto edge = lines.map.edges_begin(); edge != lines.map.edges_end(); ++edge) {
        if (edge->face() == edge->twin()->face()) {
            bridges.push_back(edge);
            continue;
        }
        for (const int side : edge->curve().data()) encloses[lines.sides[side].line] = true;
    }
    for (const auto bridge : bridges) lines.map.remove_edge(bridge);
    Contours contours;
    for (std::size_t line = 0; line < polylines.size(); ++line)
        if (!encloses[line]) contours.open.push_back(line);
    for (auto face = lines.map.faces_begin(); face != lines.map.faces_end(); ++face) {
        for (auto loop = face->inner_ccbs_begin(); loop != face->inner_ccbs_end(); ++loop)
            contours.closed.push_back(polygon_around(*loop));
    }
    return contours;
}

}  // namespace fretwork::outlines::detail
