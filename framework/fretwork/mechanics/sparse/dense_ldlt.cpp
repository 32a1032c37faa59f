// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/internal/instruction_sets.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/mechanics/sparse/dense_ldlt.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace fretwork::mechanics::sparse {
namespace {

using base::kRowsOf;
using base::read_strip;
using base::Strip2;
using base::Strip4;
using base::Strip8;
using base::write_strip;
using Index = std::ptrdiff_t;

/// The number of columns that are handled together; their products with one strip of rows stay in registers.
constexpr int kBlock = 6;
/// The number of the panel's columns that update later columns at a time, so that they stay in the cache.
constexpr int kDepth = 128;
/// The number of multiplications from which a front gets several threads. One thread would take about ten
/// times as long for them as for starting other threads.
constexpr double kLargeFront = 5e6;

/// Some columns of a dense matrix: entry (i, j) is values[i + j * stride].
struct Columns {
    double* values;
    Index stride;
    Index rows;
    int count;
};

/// The product to subtract from columns: left (rows x depth) times the transpose of `packed`, which has
/// kBlock numbers for each of `depth` columns, one after the other.
struct Product {
    const double* left;
    Index stride;
    const double* packed;
    Index depth;
    bool replaces = false;  ///< true: the columns are overwritten, whatever they contain
};

/// The factors of a diagonal block, by which the rows below it become rows of L.
struct BlockSolve {
    double unit[kBlock][kBlock] = {};  ///< L of the block; unit[k][c] for k > c
    double inverse[kBlock] = {};       ///< inverse of each pivot
};

/// True if two strips are summed together. With many registers, the sums of two strips fit into them. A
/// single strip would wait for its own results: while one fused product is computed, eight others can start.
const bool kPairsStrips = base::has_many_registers();

template <class Strip>
using Sums = Strip[kBlock];

/// Subtract the sums of one strip from its columns and, if requested, turn them into rows of L.
template <class Strip>
FRETWORK_INLINE void finish_strip(double* target, const Columns& columns, const Product& product,
                                  const BlockSolve* solve, Sums<Strip>& sum) {
#pragma GCC unroll 6
    for (int c = 0; c < kBlock; ++c) {
        if (product.replaces) {
            sum[c] = -sum[c];
        } else if (c < columns.count) {
            Strip present;
            read_strip(target + c * columns.stride, present);
            sum[c] = present - sum[c];
        }
    }
    if (solve != nullptr) {
#pragma GCC unroll 6
        for (int c = 0; c < kBlock; ++c) {
#pragma GCC unroll 6
            for (int k = c + 1; k < kBlock; ++k) sum[k] -= sum[c] * solve->unit[k][c];
            sum[c] = sum[c] * solve->inverse[c];
        }
    }
#pragma GCC unroll 6
    for (int c = 0; c < kBlock; ++c) {
        if (c < columns.count) write_strip(sum[c], target + c * columns.stride);
    }
}

/// Subtract from rows [i, i + Strips * kRowsOf<Strip>) as subtract_rows() does. The order of each sum does
/// not depend on the number of strips.
template <class Strip, int Strips>
FRETWORK_INLINE void subtract_tile(const Columns& columns, Index i, const Product& product,
                                   const BlockSolve* solve) {
    Sums<Strip> sum[Strips] = {};
    const double* left = product.left + i;
    const double* packed = product.packed;
    for (Index p = 0; p < product.depth; ++p, left += product.stride, packed += kBlock) {
        Strip a[Strips];
#pragma GCC unroll 2
        for (int s = 0; s < Strips; ++s) read_strip(left + s * kRowsOf<Strip>, a[s]);
#pragma GCC unroll 6
        for (int c = 0; c < kBlock; ++c) {
#pragma GCC unroll 2
            for (int s = 0; s < Strips; ++s) sum[s][c] += a[s] * packed[c];
        }
    }
#pragma GCC unroll 2
    for (int s = 0; s < Strips; ++s)
        finish_strip<Strip>(columns.values + i + s * kRowsOf<Strip>, columns, product, solve, sum[s]);
}

/// Subtract the product from rows [first, columns.rows) of at most kBlock columns and, if requested, turn the
/// rows into rows of L.
FRETWORK_INLINE void subtract_rows(const Columns& columns, Index first, const Product& product,
                                   const BlockSolve* solve = nullptr) {
    Index i = first;
    if (kPairsStrips) {
        for (; i + 16 <= columns.rows; i += 16) subtract_tile<Strip8, 2>(columns, i, product, solve);
    }
    for (; i + 8 <= columns.rows; i += 8) subtract_tile<Strip8, 1>(columns, i, product, solve);
    if (i + 4 <= columns.rows) {
        subtract_tile<Strip4, 1>(columns, i, product, solve);
        i += 4;
    }
    if (i + 2 <= columns.rows) {
        subtract_tile<Strip2, 1>(columns, i, product, solve);
        i += 2;
    }
    if (i < columns.rows) subtract_tile<double, 1>(columns, i, product, solve);
}

/// Pack rows [row, row + kBlock) of the panel's columns [from, to), each column times its pivot.
FRETWORK_INLINE void pack(const Front& front, Index row, Index from, Index to, double* packed) {
    const Index stride = front.width + front.rows;
    const Index count = std::min<Index>(kBlock, stride - row);
    for (Index p = from; p < to; ++p, packed += kBlock) {
        const double pivot = front.panel[p + p * stride];
        const double* entries = front.panel + row + p * stride;
        for (Index c = 0; c < kBlock; ++c) packed[c] = c < count ? pivot * entries[c] : 0.0;
    }
}

/// Eliminate the diagonal block of columns [first, first + count), entry by entry.
FRETWORK_INLINE Pivots eliminate_diagonal(const Front& front, int first, int count, const double* least_pivot,
                                          BlockSolve& solve) {
    const Index stride = front.width + front.rows;
    double* block = front.panel + first + first * stride;
    Pivots pivots;
    for (int j = 0; j < count; ++j) {
        const double pivot = block[j + j * stride];
        if (!(std::abs(pivot) > least_pivot[first + j])) {
            pivots.zero = first + j;
            return pivots;
        }
        if (pivot < 0.0) ++pivots.negative;
        if (std::abs(pivot) < kWeakPivot * least_pivot[first + j]) pivots.weak = true;
        solve.inverse[j] = 1.0 / pivot;
        for (int k = j + 1; k < count; ++k) {
            solve.unit[k][j] = block[k + j * stride] / pivot;
            for (int i = k; i < count; ++i) block[i + k * stride] -= solve.unit[k][j] * block[i + j * stride];
        }
        for (int k = j + 1; k < count; ++k) block[k + j * stride] = solve.unit[k][j];
    }
    return pivots;
}

/// Columns [from, to) of the panel, which update the later columns together.
struct Slice {
    Index from;
    Index to;
    [[nodiscard]] Index depth() const { return to - from; }
};

/// Update at most kBlock columns of a slice by the columns before them in the slice, and eliminate them.
FRETWORK_CLONES Pivots eliminate_block(const Front& front, const Slice& slice, int first,
                                       const double* least_pivot, double* packed) {
    const Index stride = front.width + front.rows;
    const int count = static_cast<int>(std::min<Index>(kBlock, slice.to - first));
    pack(front, first, slice.from, first, packed);
    double* columns = front.panel + first * stride;
    const Product before{front.panel + slice.from * stride, stride, packed, first - slice.from};
    subtract_rows({columns, stride, first + count, count}, first, before);
    BlockSolve solve;
    const Pivots pivots = eliminate_diagonal(front, first, count, least_pivot, solve);
    if (pivots.zero < 0) subtract_rows({columns, stride, stride, count}, first + count, before, &solve);
    return pivots;
}

/// Call body(first, count) for each block of columns after a slice. No block reaches from the panel into the
/// rest. The body must be inlined, too; otherwise, it is compiled for any machine.
template <class Body>
FRETWORK_INLINE void for_later_blocks(const Front& front, const Slice& slice, Index end, const Body& body) {
    for (Index column = slice.to; column < end;) {
        const Index limit = column < front.width ? front.width : front.width + front.rows;
        const auto count = static_cast<int>(std::min<Index>(kBlock, limit - column));
        body(column, count);
        column += count;
    }
}

FRETWORK_CLONES void pack_later(const Front& front, const Slice& slice, double* packed) {
    for_later_blocks(
        front, slice, front.width + front.rows, [&](Index column, int) __attribute__((always_inline)) {
            pack(front, column, slice.from, slice.to, packed);
            packed += kBlock * slice.depth();
        });
}

/// The number of rows in a strip. Its entries in a slice stay in the nearest cache while all later columns
/// are updated.
constexpr Index kStrip = 16;

/// Subtract L D L^T over a slice from one strip of rows of all columns after the slice. The first slice
/// overwrites the rest, whatever it contains.
FRETWORK_CLONES void update_strip(const Front& front, Index row, const Slice& slice, const double* packed) {
    const Index stride = front.width + front.rows;
    const double* left = front.panel + slice.from * stride;
    const Index end = std::min<Index>(row + kStrip, stride);
    for_later_blocks(
        front, slice, end, [&](Index column, int count) __attribute__((always_inline)) {
            const bool in_panel = column < front.width;
            double* target = in_panel ? front.panel + column * stride
                                      : front.rest + (column - front.width) * front.rows - front.width;
            const Index first = in_panel ? row : std::max<Index>(row, front.width);
            subtract_rows({target, in_panel ? stride : front.rows, end, count}, first,
                          {left, stride, packed, slice.depth(), !in_panel && slice.from == 0});
            packed += kBlock * slice.depth();
        });
}

/// Subtract L D L^T over a slice from all columns after the slice.
void update_later(const Front& front, const Slice& slice, double* packed, const Concurrency& concurrency) {
    const Index stride = front.width + front.rows;
    pack_later(front, slice, packed);
    const Index strips = (stride - slice.to + kStrip - 1) / kStrip;
    const auto update = [&](std::size_t strip) {
        concurrency.control.check();
        update_strip(front, slice.to + static_cast<Index>(strip) * kStrip, slice, packed);
    };
    if (concurrency.threads == 1) {
        for (Index strip = 0; strip < strips; ++strip) update(strip);
    } else {
        base::parallel_for(strips, concurrency.threads, update);
    }
}

/// Compute y += A x for a dense matrix stored by columns.
FRETWORK_INLINE void add_products(const double* matrix, Index stride, Index rows, const double* x, int count,
                                  double* __restrict y) {
    int j = 0;
    for (; j + 4 <= count; j += 4) {
        const double* __restrict a = matrix + j * stride;
        for (Index i = 0; i < rows; ++i) {
            double sum = y[i];
            sum += a[i] * x[j];
            sum += a[i + stride] * x[j + 1];
            sum += a[i + 2 * stride] * x[j + 2];
            sum += a[i + 3 * stride] * x[j + 3];
            y[i] = sum;
        }
    }
    for (; j < count; ++j) {
        const double* __restrict a = matrix + j * stride;
        for (Index i = 0; i < rows; ++i) y[i] += a[i] * x[j];
    }
}

/// Subtract the products of `Count` neighbouring columns with y from x.
template <int Count>
FRETWORK_INLINE void subtract_dots_of(const double* matrix, Index stride, Index rows, const double* y,
                                      double* x) {
    const base::Dots<Count> products = base::dots<Count>(matrix, stride, rows, y);
    for (int c = 0; c < Count; ++c) x[c] -= products.of[c];
}

/// Compute x -= A^T y.
FRETWORK_INLINE void subtract_dots(const double* matrix, Index stride, Index rows, const double* y, int count,
                                   double* x) {
    int j = 0;
    for (; j + 4 <= count; j += 4) subtract_dots_of<4>(matrix + j * stride, stride, rows, y, x + j);
    for (; j < count; ++j) subtract_dots_of<1>(matrix + j * stride, stride, rows, y, x + j);
}

FRETWORK_CLONES void forward(const Front& front, double* __restrict x, double* __restrict below) {
    const Index stride = front.width + front.rows;
    for (int j = 0; j < front.width; ++j) {
        const double* __restrict column = front.panel + j * stride;
        for (int i = j + 1; i < front.width; ++i) x[i] -= column[i] * x[j];
    }
    add_products(front.panel + front.width, stride, front.rows, x, front.width, below);
}

FRETWORK_CLONES void back(const Front& front, double* x, const double* below) {
    const Index stride = front.width + front.rows;
    for (int j = 0; j < front.width; ++j) x[j] /= front.panel[j + j * stride];
    subtract_dots(front.panel + front.width, stride, front.rows, below, front.width, x);
    for (int j = front.width - 1; j >= 0; --j)
        subtract_dots_of<1>(front.panel + j * stride + j + 1, stride, front.width - j - 1, x + j + 1, x + j);
}

/// Add the columns of runs[first], on and below their diagonals, to columns of the next front. `target` is
/// the column to which the first of them is added.
FRETWORK_INLINE void add_run(const Remainder& remainder, std::size_t first, double* target, Index stride) {
    const RowRun& own = remainder.runs[first];
    for (Index column = own.from; column < own.from + own.length; ++column, target += stride) {
        const double* source = remainder.rest + column * remainder.rows;
        for (std::size_t r = first; r < remainder.runs.size(); ++r) {
            const RowRun& run = remainder.runs[r];
            const Index begin = r == first ? column : run.from;
            double* __restrict to = target + run.to - run.from;
            for (Index i = begin; i < run.from + run.length; ++i) to[i] += source[i];
        }
    }
}

}  // namespace

FRETWORK_CLONES void add_to_panel(const Remainder& remainder, const Front& front) {
    const Index stride = front.width + front.rows;
    for (std::size_t r = 0; r < remainder.runs.size() && remainder.runs[r].to < front.width; ++r)
        add_run(remainder, r, front.panel + remainder.runs[r].to * stride, stride);
}

FRETWORK_CLONES void add_to_rest(const Remainder& remainder, const Front& front) {
    for (std::size_t r = 0; r < remainder.runs.size(); ++r) {
        const Index place = remainder.runs[r].to - front.width;
        if (place >= 0) add_run(remainder, r, front.rest + place * front.rows - front.width, front.rows);
    }
}

void require_finite(std::span<const double> diagonal) {
    if (!std::all_of(diagonal.begin(), diagonal.end(), [](double value) { return std::isfinite(value); }))
        throw base::NumericalError("the stiffness holds a number that is not finite");
}

Pivots eliminate(const Front& front, const ZeroPivot& zero, std::vector<double>& scratch,
                 const Concurrency& concurrency) {
    const Index stride = front.width + front.rows;
    const Index blocks = stride / kBlock + 2;
    const Index packed_size = std::min(front.width, kDepth) * blocks * kBlock;
    if (static_cast<Index>(scratch.size()) < packed_size + front.width)
        scratch.resize(packed_size + front.width);
    double* least_pivot = scratch.data() + packed_size;
    for (int j = 0; j < front.width; ++j) least_pivot[j] = zero.share * std::abs(zero.diagonal[j]);
    const bool is_large = 0.5 * front.width * static_cast<double>(stride * stride) >= kLargeFront;
    const Concurrency useful{is_large ? concurrency.threads : 1, concurrency.control};
    Pivots pivots;
    for (Index from = 0; from < front.width; from += kDepth) {
        const Slice slice{from, std::min<Index>(from + kDepth, front.width)};
        for (Index first = from; first < slice.to; first += kBlock) {
            concurrency.control.check();
            const Pivots found =
                eliminate_block(front, slice, static_cast<int>(first), least_pivot, scratch.data());
            pivots.negative += found.negative;
            pivots.weak = pivots.weak || found.weak;
            pivots.zero = found.zero;
            if (found.zero >= 0) return pivots;
        }
        update_later(front, slice, scratch.data(), useful);
    }
    return pivots;
}

void substitute_forward(const Front& front, double* x, double* below) {
    forward(front, x, below);
}

void substitute_back(const Front& front, double* x, const double* below) {
    back(front, x, below);
}

}  // namespace fretwork::mechanics::sparse
