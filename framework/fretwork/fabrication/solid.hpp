// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/fabrication/shape.hpp>

#include <array>
#include <vector>

namespace fretwork::fabrication {

/// A closed surface of triangles, counterclockwise seen from outside.
struct Solid {
    std::vector<std::array<double, 3>> vertices;  ///< m
    std::vector<std::array<int, 3>> triangles;
};

struct SolidOptions {
    double chord_tolerance = 5e-6;  ///< m, by which chords may be off arcs
    base::Control control{};
    /// Throws InputError.
    void validate() const;
};

/// A shape extruded from z = 0 to its height. Vertices lie on a grid of a tenth of a micrometre (coarser for
/// shapes of more than a metre: 2^-22 of the size), so that they stay apart as 32 bit numbers in millimetres.
///
/// Law: every edge has two triangles, in opposite directions. Throws GeometryError that names the place where
/// the shape touches itself, where no such solid exists; Stopped.
Solid make_solid(const Shape& shape, const SolidOptions& options = {});

/// m3
double volume(const Solid& solid);

/// The closed sides of a solid.
struct SolidCheck {
    std::size_t open_edges = 0;  ///< directed edges without exactly one triangle that has the opposite one
    long euler_number = 0;       ///< vertices - edges + triangles: 2 for each piece less 2 for each opening
};
SolidCheck check(const Solid& solid);

}  // namespace fretwork::fabrication
