// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of a .dxf and solids of an .obj, measured.
#pragma once

#include "exports/dxf_reading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

namespace fretwork::test {

using exports::test::polylines;
using fabrication::Contour;
using geometry::Box;

inline double area(const std::vector<Contour>& contours) {
    double sum = 0.0;
    for (const Contour& contour : contours) sum += signed_area(contour);
    return sum;
}

inline Box extents(const std::vector<Contour>& contours) {
    Box box = box_of(contours.front());
    for (const Contour& contour : contours) box = united(box, box_of(contour));
    return box;
}

/// The turns of all arcs; those around an inner corner of the material turn right, the others left.
enum class Turn { Left, Right };
inline std::vector<double> arc_radii(const std::vector<Contour>& contours, Turn turn) {
    std::vector<double> radii;
    for (const Contour& contour : contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            if (contour[i].bulge == 0.0 || (contour[i].bulge < 0.0) != (turn == Turn::Right)) continue;
            radii.push_back(arc_between(contour[i], contour[(i + 1) % contour.size()].place).radius);
        }
    }
    return radii;
}

/// The middles of round holes of a diameter.
inline std::vector<geometry::Point2> holes(const std::vector<Contour>& contours, double diameter) {
    std::vector<geometry::Point2> middles;
    for (const Contour& contour : contours) {
        const Box box = box_of(contour);
        const double disc = 0.25 * std::numbers::pi * diameter * diameter;
        if (std::abs(signed_area(contour) + disc) > 1e-4 * disc) continue;
        middles.push_back({0.5 * (box.xmin + box.xmax), 0.5 * (box.ymin + box.ymax)});
    }
    return middles;
}

/// The volume within triangles, mm3, and the extents, mm, of their corners.
struct Measured {
    double volume = 0.0;
    std::array<double, 3> least{1e9, 1e9, 1e9}, most{-1e9, -1e9, -1e9};
};
inline Measured measured_obj(const std::string& text) {
    Measured measured;
    std::vector<std::array<double, 3>> corners;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            auto& p = corners.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                words >> p[k];
                measured.least[k] = std::min(measured.least[k], p[k]);
                measured.most[k] = std::max(measured.most[k], p[k]);
            }
        } else if (kind == "f") {
            std::size_t a = 0, b = 0, c = 0;
            words >> a >> b >> c;
            const auto &p = corners.at(a - 1), &q = corners.at(b - 1), &r = corners.at(c - 1);
            measured.volume += (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
                                p[2] * (q[0] * r[1] - q[1] * r[0])) /
                               6.0;
        }
    }
    return measured;
}

}  // namespace fretwork::test
