// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <limits>
#include <span>
#include <vector>

namespace fretwork::mechanics::sparse {

/// The dense matrix in which the columns of one supernode are eliminated (lower triangle, by columns). It has
/// a panel of `width` columns with width + rows entries each, and a square rest that the panel's elimination
/// leaves to later columns.
struct Front {
    int width = 0;
    int rows = 0;
    double* panel = nullptr;  ///< (width + rows) x width; afterwards D on the diagonal, unit L below it
    double* rest = nullptr;   ///< rows x rows; only the lower triangle is used
};

/// Rows that are neighbours in one front, and also in the next.
struct RowRun {
    int from = 0;    ///< the first of them below the columns of the first front
    int to = 0;      ///< its row in the next front
    int length = 0;  ///< all are columns of the next front's panel, or none
};

/// What an eliminated front leaves to the next, and where its rows come there: ascending.
struct Remainder {
    const double* rest;  ///< rows x rows, lower triangle
    int rows;
    std::span<const RowRun> runs;
};

/// Add the columns that the next front eliminates: to its panel, before.
void add_to_panel(const Remainder& remainder, const Front& front);
/// Add the others: to its rest, afterwards.
void add_to_rest(const Remainder& remainder, const Front& front);

/// A pivot below this share of its diagonal entry counts as zero, because only rounding is left of it.
constexpr double kZeroPivot = 64.0 * std::numeric_limits<double>::epsilon();

constexpr double kWeakPivot = 1e4;

/// Throws NumericalError if an entry of a stiffness' diagonal is not finite.
void require_finite(std::span<const double> diagonal);

/// The signs and sizes of the pivots of an elimination.
struct Pivots {
    int negative = 0;
    int zero = -1;      ///< the column that stopped the elimination; -1: none
    bool weak = false;  ///< a pivot was less than kWeakPivot times the size that counts as zero
};

/// The rule for zero pivots: a pivot is zero if it is not above `share` times the column's entry in
/// `diagonal`.
struct ZeroPivot {
    std::span<const double> diagonal;
    double share = 0.0;
};

/// The threads that eliminate a front.
struct Crew {
    int threads = 1;  ///< number on large fronts; 0: one for each processor. It does not change a bit of a
                      ///< result.
    base::Control control{};
};

/// Eliminate the front's columns: F = L D L^T in the panel, and rest = -L D L^T of the rows below. Pivots are
/// not exchanged, so a pivot that counts as zero ends the elimination. `scratch` grows as needed. The kernels
/// are compiled for several instruction sets, and the machine picks one at run time. Throws Stopped.
Pivots eliminate(const Front& front, const ZeroPivot& zero, std::vector<double>& scratch,
                 const Crew& crew = {});

/// x = L^-1 x for the panel's own columns, and below += L x for the rows below them.
void substitute_forward(const Front& front, double* x, double* below);
/// x = D^-1 x, then x = L^-T (x - L^T below) with the solution at the rows below.
void substitute_back(const Front& front, double* x, const double* below);

}  // namespace fretwork::mechanics::sparse
