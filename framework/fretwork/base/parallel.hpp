// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace fretwork::base {

/// The number of threads for a request of `wanted` threads (0: one for each processor), at most 256.
int resolved_thread_count(int wanted);

/// Call body(i) for every i below `count`, on up to `threads` threads (0: one for each processor).
///
/// Any thread may take any index, so body(i) may write only to element i; the result then does not depend on
/// the number of threads. After a call has thrown, calls that have not begun are left out. If several calls
/// throw, the exception of the call with the smallest index is rethrown.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

/// Call body(i) for every node of a tree after the calls for its children, on up to `threads` threads (0: one
/// for each processor). The parent of node i is parent[i], a number above i, or -1 at a root.
///
/// Any thread may take any node whose children are done. If body(i) throws, body is not called for the
/// ancestors of node i, but still for all other nodes. The exception of the call with the smallest index is
/// rethrown at the end.
void parallel_tree(std::span<const int> parent, int threads, const std::function<void(std::size_t)>& body);

}  // namespace fretwork::base
