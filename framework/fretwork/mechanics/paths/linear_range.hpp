// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/results/solution.hpp>

namespace fretwork::mechanics {

struct Assembly;

/// Estimates how far a linear solution is from the one for large displacements, from its own strains and
/// turns.
struct LinearRange {
    /// By estimate: the largest error of a translation as a share of the largest displacement. Good to a
    /// factor of about two as long as it is below one, and large where the truth is.
    double error = 0.0;
    /// The load is beyond the first one of linearized buckling: the structure may go elsewhere altogether.
    bool loses_stability = false;
    friend bool operator==(const LinearRange&, const LinearRange&) = default;
};

/// Options of linear_range().
struct LinearRangeOptions {
    int threads = 1;  ///< 0: all there are
    base::Control control{};
};

/// The linear solution u1 is the first term of the path u = p u1 + p^2 u2 + p^3 u3 + .. in the load p. The
/// next two are two more solutions with the same stiffness: u2 (a turned beam's end moves back along it)
/// under the forces that are quadratic in u1, u3 under the cubic ones of u1 and u2, both differences of the
/// elements' forces. Where u3 is directed against u1, held ends stiffen the structure, and p x + p^3 q x^3 =
/// p gives the share x of u1 that is left.
///
/// The elements must be made for large displacements. Throws as LinearSolver.
LinearRange linear_range(const Assembly& assembly, const LinearRangeOptions& options = {});

/// The same, and the linear solution itself, which it takes anyway.
struct LinearPath {
    LinearRange range;
    NodeValues displacements;  ///< u1; the assembly's reported nodes first
};
LinearPath linear_path(const Assembly& assembly, const LinearRangeOptions& options = {});

}  // namespace fretwork::mechanics
