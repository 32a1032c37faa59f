// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

namespace fretwork::mechanics::sparse {

struct LargeArrayDeleter {
    void operator()(double* numbers) const;
};
using LargeArray = std::unique_ptr<double[], LargeArrayDeleter>;

/// Numbers without values. Where there are millions of them, the system is asked for large pages: it then
/// hands out a page per 2 MB rather than per 4 kB, and a pass through all numbers misses no page's address.
LargeArray make_large_array(std::size_t size);

}  // namespace fretwork::mechanics::sparse
