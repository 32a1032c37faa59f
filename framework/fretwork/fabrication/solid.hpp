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
    double chord_tolerance = 5e-6;  ///< largest distance between an arc and its chords, m, at least 1e-7
    base::Control control{};        ///< progress and stop
    /// Throws InputError that names an invalid option.
    void validate() const;
};

/// Extrude a shape from z = 0 to its height. x and y lie on a grid with a spacing of a tenth of a micrometre
/// or, if a coordinate is above 0.42 m, of 2^-22 of the largest coordinate. Vertices thus still differ as
/// 32-bit numbers in millimetres.
///
/// Every edge of the solid belongs to two triangles, in opposite directions. A shape that touches itself has
/// no such solid: throws GeometryError, with the place if it is known. Throws InputError if an option is
/// invalid. Throws Stopped.
Solid make_solid(const Shape& shape, const SolidOptions& options = {});

/// The volume of a solid, m3.
double volume(const Solid& solid);

/// The result of checking that a solid is closed.
struct SolidCheck {
    std::size_t open_edges = 0;  ///< number of directed edges that are repeated or lack an opposite edge
    /// Vertices - edges + triangles, which should be 2 for each piece minus 2 for each opening.
    long euler_number = 0;
};
/// Check that a solid is closed and oriented.
SolidCheck check(const Solid& solid);

}  // namespace fretwork::fabrication
