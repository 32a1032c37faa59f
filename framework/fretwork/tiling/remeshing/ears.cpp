// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/plane.hpp>
#include <fretwork/tiling/remeshing/ears.hpp>

namespace fretwork::tiling::detail {
namespace {

using geometry::Point2;

class EarFlipper {
  public:
    EarFlipper(Triangulation& triangulation, const Work& work) : t_(triangulation), work_(work) {}

    /// A flip may make the next ear.
    void run() {
        for (bool has_flipped = true; has_flipped;) {
            has_flipped = false;
            for (int triangle = 0; triangle < static_cast<int>(t_.triangles.size()); ++triangle)
                has_flipped = flip_if_ear(triangle) || has_flipped;
        }
    }

  private:
    [[nodiscard]] std::array<int, 3>& corners(int triangle) {
        return t_.triangles[static_cast<std::size_t>(triangle)];
    }
    [[nodiscard]] std::array<int, 3>& behind(int triangle) {
        return t_.neighbors[static_cast<std::size_t>(triangle)];
    }
    [[nodiscard]] Point2 place(int point) const { return t_.points[static_cast<std::size_t>(point)]; }

    /// The corner opposite to the only side of an ear that is not on the rim; -1: no ear.
    int tip_of(int triangle) {
        int open = -1;
        int count = 0;
        for (int i = 0; i < 3; ++i) {
            if (behind(triangle)[static_cast<std::size_t>(i)] < 0) continue;
            open = i;
            ++count;
        }
        return count == 1 ? open : -1;
    }

    bool flip_if_ear(int ear) {
        work_.check();
        const int tip = tip_of(ear);
        if (tip < 0) return false;
        const auto at = [](int i) { return static_cast<std::size_t>(i % 3); };
        const int other = behind(ear)[at(tip)];
        const int a = corners(ear)[at(tip)];
        const int b = corners(ear)[at(tip + 1)];
        const int c = corners(ear)[at(tip + 2)];
        const int far = (corner_at(corners(other), b) + 1) % 3;  // c, b, d in the other triangle's order
        const int d = corners(other)[at(far)];
        if (t_.is_rim(d) || !is_convex(a, b, c, d)) return false;
        const int behind_bd = behind(other)[at(corner_at(corners(other), c))];
        const int behind_dc = behind(other)[at(corner_at(corners(other), b))];
        corners(ear) = {a, b, d};
        behind(ear) = {behind_bd, other, -1};
        corners(other) = {a, d, c};
        behind(other) = {behind_dc, -1, ear};
        if (behind_bd >= 0) {
            for (int& neighbor : behind(behind_bd)) neighbor = neighbor == other ? ear : neighbor;
        }
        return true;
    }
    /// Whether the diagonal from a to d lies within the quadrilateral a b d c.
    [[nodiscard]] bool is_convex(int a, int b, int c, int d) const {
        const Point2 diagonal = place(d) - place(a);
        return cross(diagonal, place(c) - place(a)) > 0 && cross(diagonal, place(b) - place(a)) < 0 &&
               cross(place(b) - place(d), place(c) - place(d)) < 0;
    }

    Triangulation& t_;
    const Work& work_;
};

}  // namespace

void flip_ears(Triangulation& triangulation, const Work& work) {
    EarFlipper(triangulation, work).run();
}

std::vector<Chord> chords_of(const Triangulation& triangulation) {
    std::vector<Chord> chords;
    for (std::size_t triangle = 0; triangle < triangulation.triangles.size(); ++triangle) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int from = triangulation.triangles[triangle][(i + 1) % 3];
            const int to = triangulation.triangles[triangle][(i + 2) % 3];
            const int behind = triangulation.neighbors[triangle][i];
            if (behind > static_cast<int>(triangle) && triangulation.is_rim(from) && triangulation.is_rim(to))
                chords.push_back({from, to});
        }
    }
    return chords;
}

}  // namespace fretwork::tiling::detail
