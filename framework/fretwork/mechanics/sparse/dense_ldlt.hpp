// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <limits>
#include <span>
#include <vector>

namespace fretwork::mechanics::sparse {

/// The dense matrix in which one supernode's columns are eliminated (lower triangle, by columns). A front has
/// a panel of `width` columns with width + rows entries each, and a square rest, which goes to later columns.
struct Front {
    int width = 0;
    int rows = 0;
    /// (width + rows) x width; after the elimination, D is on the diagonal and unit L below the diagonal.
    double* panel = nullptr;
    double* rest = nullptr;  ///< rows x rows; only the lower triangle is used
};

/// A run of rows that are neighbours in a front and in the next front, which takes the first front's rest.
struct RowRun {
    int from = 0;    ///< first row of the run, counted below the columns of the first front
    int to = 0;      ///< place of this row in the next front
    int length = 0;  ///< number of rows; either all or none belong to columns of the next front's panel
};

/// The rest of an eliminated front for the next front, and the places of its rows there, ascending.
struct Remainder {
    const double* rest;  ///< rows x rows, lower triangle
    int rows;
    std::span<const RowRun> runs;
};

/// Add the part of a remainder that belongs to columns of the next front's panel, before the elimination of
/// that front.
void add_to_panel(const Remainder& remainder, const Front& front);
/// Add all other columns of a remainder to the next front's rest, after the elimination of that front.
void add_to_rest(const Remainder& remainder, const Front& front);

/// A pivot whose absolute value is below this share of its diagonal entry counts as zero: it is only
/// rounding.
constexpr double kZeroPivot = 64.0 * std::numeric_limits<double>::epsilon();

constexpr double kWeakPivot = 1e4;

/// Throw NumericalError if an entry of a stiffness' diagonal is not finite.
void require_finite(std::span<const double> diagonal);

/// The signs and sizes of the pivots of an elimination.
struct Pivots {
    int negative = 0;
    int zero = -1;      ///< column that stopped the elimination; -1: none
    bool weak = false;  ///< true if a pivot was less than kWeakPivot times the size that counts as zero
};

/// The rule for zero pivots: a pivot is zero if its absolute value is not above `share` times that of the
/// column's entry in `diagonal`.
struct ZeroPivot {
    std::span<const double> diagonal;
    double share = 0.0;
};

/// The threads that eliminate a front.
struct Concurrency {
    /// Number of threads for large fronts; 0: one for each processor. The result is bitwise the same for
    /// every number of threads.
    int threads = 1;
    base::Control control{};
};

/// Eliminate the front's columns: F = L D L^T in the panel, and rest = -L D L^T with the rows of L below the
/// panel's own columns. Pivots are not exchanged, so a zero pivot ends the elimination. `scratch` grows as
/// needed. The kernels are compiled for several instruction sets; one is chosen at run time. Throws Stopped.
Pivots eliminate(const Front& front, const ZeroPivot& zero, std::vector<double>& scratch,
                 const Concurrency& concurrency = {});

/// Compute x = L^-1 x for the panel's own columns, and below += B x, where B has the rows of L below them.
void substitute_forward(const Front& front, double* x, double* below);
/// Compute x = D^-1 x, then x = L^-T (x - B^T below), where B has the rows of L below the panel's own
/// columns, and `below` is the solution at these rows.
void substitute_back(const Front& front, double* x, const double* below);

}  // namespace fretwork::mechanics::sparse
