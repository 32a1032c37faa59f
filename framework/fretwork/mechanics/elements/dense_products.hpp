// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace fretwork::mechanics::elements {

/// A dense matrix, stored by columns in memory of the caller.
struct DenseMatrix {
    const double* values;
    std::ptrdiff_t rows;
    std::ptrdiff_t columns;
};

/// Compute y = A x. Each row's sum adds the columns in their order.
void multiply_by_vector(const DenseMatrix& a, const double* x, double* y);

/// Compute y += A^T x.
void add_transposed_product(const DenseMatrix& a, const double* x, double* y);

enum class Sum { Add, Replace };

/// Compute out += A m or out = A m. A and out have three columns each, and m is 3 x 3, all stored by columns.
void multiply_by_three(const DenseMatrix& a, const double* m, Sum sum, double* out);

/// Compute the lower triangle of C += A W^T + W A^T, where A and W are n x 3 and C is n x n.
void add_symmetric_product(const DenseMatrix& a, const double* w, double* c);

}  // namespace fretwork::mechanics::elements
