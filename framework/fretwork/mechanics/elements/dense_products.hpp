// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace fretwork::mechanics::elements {

/// A dense matrix by columns, in memory of the caller.
struct DenseMatrix {
    const double* values;
    std::ptrdiff_t rows;
    std::ptrdiff_t columns;
};

/// y = A x. The sum of each row is made in the order of the columns.
void multiply_by_vector(const DenseMatrix& a, const double* x, double* y);

/// y += A^T x.
void add_transposed_product(const DenseMatrix& a, const double* x, double* y);

enum class Sum { Add, Replace };

/// out += A m or out = A m, where A and out have three columns each, and m (3 x 3) is by columns, too.
void multiply_by_three(const DenseMatrix& a, const double* m, Sum sum, double* out);

/// The lower triangle of C += A W^T + W A^T, where A and W are n x 3 and C is n x n.
void add_symmetric_product(const DenseMatrix& a, const double* w, double* c);

}  // namespace fretwork::mechanics::elements
