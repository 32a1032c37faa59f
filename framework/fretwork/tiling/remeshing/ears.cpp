// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/remeshing/triangulation.hpp>

#include <algorithm>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;

class EarFlipper {
  public:
    EarFlipper(Triangulation& triangulation, const SharedTask& task) : t_(triangulation), task_(task) {}

    /// Flip all ears. A flip may make another ear.
    void run() {
        for (bool has_flipped = true; has_flipped;) {
            has_flipped = false;
            for (const TriangleIndex triangle : t_.triangles.indices())
                has_flipped = flip_if_ear(triangle) || has_flipped;
        }
    }

  private:
    [[nodiscard]] std::array<PointIndex, 3>& corners(TriangleIndex triangle) {
        return t_.triangles[triangle];
    }
    [[nodiscard]] std::array<TriangleIndex, 3>& behind(TriangleIndex triangle) {
        return t_.neighbors[triangle];
    }
    [[nodiscard]] Point2 place(PointIndex point) const { return t_.points[point]; }

    /// The corner opposite to the only side of an ear that is not on the rim; -1: the triangle is not an ear.
    int tip_of(TriangleIndex triangle) {
        int open = -1;
        int count = 0;
        for (int i = 0; i < 3; ++i) {
            if (!behind(triangle)[i].is_valid()) continue;
            open = i;
            ++count;
        }
        return count == 1 ? open : -1;
    }

    bool flip_if_ear(TriangleIndex ear) {
        task_.check();
        const int tip = tip_of(ear);
        if (tip < 0) return false;
        const TriangleIndex other = behind(ear)[tip];
        const PointIndex a = corners(ear)[tip];
        const PointIndex b = corners(ear)[(tip + 1) % 3];
        const PointIndex c = corners(ear)[(tip + 2) % 3];
        // The other triangle has the corners c, b, d in this order.
        const int far = (corner_at(corners(other), b) + 1) % 3;
        const PointIndex d = corners(other)[far];
        if (t_.is_rim(d) || !is_convex(a, b, c, d)) return false;
        const TriangleIndex behind_bd = behind(other)[corner_at(corners(other), c)];
        const TriangleIndex behind_dc = behind(other)[corner_at(corners(other), b)];
        corners(ear) = {a, b, d};
        behind(ear) = {behind_bd, other, {}};
        corners(other) = {a, d, c};
        behind(other) = {behind_dc, {}, ear};
        if (behind_bd.is_valid()) std::ranges::replace(behind(behind_bd), other, ear);
        return true;
    }
    /// True if the diagonal from a to d lies within the quadrilateral a b d c.
    [[nodiscard]] bool is_convex(PointIndex a, PointIndex b, PointIndex c, PointIndex d) const {
        const Point2 diagonal = place(d) - place(a);
        return cross(diagonal, place(c) - place(a)) > 0 && cross(diagonal, place(b) - place(a)) < 0 &&
               cross(place(b) - place(d), place(c) - place(d)) < 0;
    }

    Triangulation& t_;
    const SharedTask& task_;
};

}  // namespace

void flip_ears(Triangulation& triangulation, const SharedTask& task) {
    EarFlipper(triangulation, task).run();
}

std::vector<Chord> chords_of(const Triangulation& triangulation) {
    std::vector<Chord> chords;
    for (const TriangleIndex triangle : triangulation.triangles.indices()) {
        for (std::size_t i = 0; i < 3; ++i) {
            const PointIndex from = triangulation.triangles[triangle][(i + 1) % 3];
            const PointIndex to = triangulation.triangles[triangle][(i + 2) % 3];
            const TriangleIndex behind = triangulation.neighbors[triangle][i];
            if (behind > triangle && triangulation.is_rim(from) && triangulation.is_rim(to))
                chords.push_back({from, to});
        }
    }
    return chords;
}

}  // namespace fretwork::tiling::detail
