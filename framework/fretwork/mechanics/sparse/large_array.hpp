// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

namespace fretwork::mechanics::sparse {

struct LargeArrayDeleter {
    void operator()(double* numbers) const;
};
using LargeArray = std::unique_ptr<double[], LargeArrayDeleter>;

/// Allocate uninitialized numbers. For 2 MiB and more, pages of 2 MiB instead of 4 KiB are requested, to
/// avoid page faults and misses of the address cache. Throws std::bad_alloc.
LargeArray make_large_array(std::size_t size);

}  // namespace fretwork::mechanics::sparse
