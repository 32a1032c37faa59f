// SPDX-License-Identifier: GPL-3.0-or-later
// The products that elements of many nodes are computed from. The products are small and many. Matrix
// expressions, compiled for any machine, take three times as long.
#include <fretwork/base/internal/instruction_sets.hpp>
#include <fretwork/mechanics/elements/dense_products.hpp>

namespace fretwork::mechanics::elements {
namespace {

using Index = std::ptrdiff_t;

using base::kRowsOf;

/// Rows [i, i + Strips * kRowsOf<Strip>) of A x. The sums of several strips are computed side by side,
/// because each operation of a single strip would wait for the one before.
template <class Strip, int Strips>
FRETWORK_INLINE void multiply_rows(const DenseMatrix& a, Index i, const double* x, double* y) {
    Strip sum[Strips] = {};
    const double* column = a.values + i;
    for (Index j = 0; j < a.columns; ++j, column += a.rows) {
#pragma GCC unroll 4
        for (int s = 0; s < Strips; ++s) {
            Strip entries;
            base::read_strip(column + s * kRowsOf<Strip>, entries);
            sum[s] += entries * x[j];
        }
    }
#pragma GCC unroll 4
    for (int s = 0; s < Strips; ++s) base::write_strip(sum[s], y + i + s * kRowsOf<Strip>);
}

/// Add the products of `Count` neighbouring columns with x to y.
template <int Count>
FRETWORK_INLINE void add_dots_of(const double* columns, Index rows, const double* x, double* y) {
    const base::Dots<Count> products = base::dots<Count>(columns, rows, rows, x);
    for (int c = 0; c < Count; ++c) y[c] += products.of[c];
}

}  // namespace

FRETWORK_CLONES void multiply_by_vector(const DenseMatrix& a, const double* x, double* y) {
    Index i = 0;
    for (; i + 32 <= a.rows; i += 32) multiply_rows<base::Strip8, 4>(a, i, x, y);
    for (; i + 8 <= a.rows; i += 8) multiply_rows<base::Strip8, 1>(a, i, x, y);
    for (; i + 4 <= a.rows; i += 4) multiply_rows<base::Strip4, 1>(a, i, x, y);
    for (; i + 2 <= a.rows; i += 2) multiply_rows<base::Strip2, 1>(a, i, x, y);
    for (; i < a.rows; ++i) multiply_rows<double, 1>(a, i, x, y);
}

FRETWORK_CLONES void add_transposed_product(const DenseMatrix& a, const double* x, double* y) {
    Index j = 0;
    for (; j + 6 <= a.columns; j += 6) add_dots_of<6>(a.values + j * a.rows, a.rows, x, y + j);
    for (; j < a.columns; ++j) add_dots_of<1>(a.values + j * a.rows, a.rows, x, y + j);
}

FRETWORK_CLONES void multiply_by_three(const DenseMatrix& a, const double* m, Sum sum, double* out) {
    const Index n = a.rows;
    const double* __restrict from = a.values;
    for (Index c = 0; c < 3; ++c) {
        double* __restrict to = out + c * n;
        if (sum == Sum::Replace) {
            for (Index i = 0; i < n; ++i) to[i] = 0.0;
        }
        for (Index i = 0; i < n; ++i) {
            double value = to[i];
            value += from[i] * m[3 * c];
            value += from[n + i] * m[3 * c + 1];
            value += from[2 * n + i] * m[3 * c + 2];
            to[i] = value;
        }
    }
}

FRETWORK_CLONES void add_symmetric_product(const DenseMatrix& a, const double* w, double* c) {
    const Index n = a.rows;
    const double* __restrict left = a.values;
    const double* __restrict right = w;
    for (Index j = 0; j < n; ++j) {
        double* __restrict column = c + j * n;
        for (Index i = j; i < n; ++i) {
            double value = column[i];
            for (Index k = 0; k < 3; ++k) {
                value += left[k * n + i] * right[k * n + j];
                value += right[k * n + i] * left[k * n + j];
            }
            column[i] = value;
        }
    }
}

}  // namespace fretwork::mechanics::elements
