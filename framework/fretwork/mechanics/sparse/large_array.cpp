// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/sparse/large_array.hpp>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace fretwork::mechanics::sparse {
namespace {

/// The size of a large page. Large pages begin at multiples of this size; smaller arrays only need whole
/// cache lines.
constexpr std::size_t kLargePage = std::size_t{1} << 21;
constexpr std::size_t kCacheLine = 64;

}  // namespace

void LargeArrayDeleter::operator()(double* numbers) const {
    std::free(numbers);
}

LargeArray make_large_array(std::size_t size) {
    if (size > std::numeric_limits<std::size_t>::max() / sizeof(double) - kLargePage) throw std::bad_alloc();
    const std::size_t bytes = std::max(size * sizeof(double), kCacheLine);
    const std::size_t unit = bytes < kLargePage ? kCacheLine : kLargePage;
    const std::size_t whole = (bytes + unit - 1) / unit * unit;
    void* memory = std::aligned_alloc(unit, whole);
    if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    // If the request is refused, the memory is still valid.
    if (unit == kLargePage) madvise(memory, whole, MADV_HUGEPAGE);
#endif
    return LargeArray(static_cast<double*>(memory));
}

}  // namespace fretwork::mechanics::sparse
