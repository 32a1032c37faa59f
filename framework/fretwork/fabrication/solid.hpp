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
    std::vector<std::array<int, 3>> triangles;    ///< counterclockwise seen from outside
};

/// Options of make_solid().
struct SolidOptions {
    double chord_tolerance = 5e-6;  ///< largest distance between an arc and its chords, m
    base::Control control{};        ///< progress and stop
    /// Throws InputError that names an invalid option.
    void validate() const;
};

/// Extrude a shape from z = 0 to its height. Vertices lie on a grid with a spacing of a tenth of a
/// micrometre, or of 2^-22 of the size for shapes of more than a metre, so that they still differ as 32-bit
/// numbers in millimetres.
///
/// Every edge of the solid belongs to two triangles, in opposite directions. A shape that touches itself has
/// no such solid: throws GeometryError that names the place. Throws Stopped.
Solid make_solid(const Shape& shape, const SolidOptions& options = {});

/// The volume of a solid, m3.
double volume(const Solid& solid);

/// The result of checking that a solid is closed.
struct SolidCheck {
    std::size_t open_edges = 0;  ///< number of directed edges without exactly one opposite edge
    /// Vertices - edges + triangles, which should be 2 for each piece minus 2 for each opening.
    long euler_number = 0;
};
/// Check that a solid is closed and oriented.
SolidCheck check(const Solid& solid);

}  // namespace fretwork::fabrication
