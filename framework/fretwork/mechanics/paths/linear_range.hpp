// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/mechanics/results/solution.hpp>

namespace fretwork::mechanics {

struct Assembly;

/// An estimate of the difference between a linear solution and the solution for large displacements.
struct LinearRange {
    /// The estimated largest error of a translation, as a share of the largest translation for
    /// large displacements. An estimate below 1 is within a factor of about two of the true error. If the
    /// true error is large, the estimate is large, too.
    double error = 0.0;
    /// True if the load exceeds the first load of linearized buckling: the structure may then buckle.
    bool loses_stability = false;
    friend bool operator==(const LinearRange&, const LinearRange&) = default;
};

/// Options of linear_range().
struct LinearRangeOptions {
    int threads = 1;          ///< number of threads; 0: one for each processor
    base::Control control{};  ///< progress and stop
};

/// Estimate the error of a linear solution. The linear solution u1 is the first term of the path u = p u1 +
/// p^2 u2 + p^3 u3 + .. in the load p. The next two terms take two more solutions with the same stiffness.
/// The forces that cause u2 are quadratic in u1; for example, the end of a turning beam also moves back along
/// the beam. The forces that cause u3 have terms cubic in u1, and terms bilinear in u1 and u2. Both are
/// computed as differences of the elements' forces. Let q = -(u1 . u3) / (u1 . u1), over translations alone.
/// If q > 0, held ends stiffen the structure: at p = 1, it moves by x u1 only, where x + q x^3 = 1.
///
/// The elements must be made for large displacements. Throws as LinearSolver and buckling_modes().
LinearRange linear_range(const Assembly& assembly, const LinearRangeOptions& options = {});

/// The estimate of linear_range() together with the linear solution, which the estimate needs anyway.
struct LinearPath {
    LinearRange range;  ///< estimated error of the linear solution
    /// Displacements u1 of the linear solution, one row for each node of the assembly.
    NodeValues displacements;
};
/// Estimate the error as linear_range() does, and return the linear solution, too. Throws as linear_range().
LinearPath linear_path(const Assembly& assembly, const LinearRangeOptions& options = {});

}  // namespace fretwork::mechanics
