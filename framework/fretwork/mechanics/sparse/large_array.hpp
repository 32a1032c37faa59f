// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

namespace fretwork::mechanics::sparse {

struct LargeArrayDeleter {
    void operator()(double* numbers) const;
};
using LargeArray = std::unique_ptr<double[], LargeArrayDeleter>;

/// Allocate uninitialized numbers. For millions of numbers, pages of 2 MB instead of 4 kB are requested, to
/// avoid page faults and misses of the address cache.
LargeArray make_large_array(std::size_t size);

}  // namespace fretwork::mechanics::sparse
