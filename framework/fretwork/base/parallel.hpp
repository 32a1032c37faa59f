// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace fretwork::base {

/// The number of threads that a wish of `wanted` (0: all there are) gives on this machine: at most 256.
int resolved_thread_count(int wanted);

/// Call body(i) for every i below `count`, on up to `threads` threads (0: all there are).
///
/// A body may write only to the place of its own index, because any thread may take any index; then the
/// result does not depend on the number of threads. If several bodies throw, the exception of the smallest
/// index is thrown on.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

/// Call body(i) for every node of a tree after the calls for its children, on up to `threads` threads (0: all
/// there are). parent[i] > i, or -1 at a root.
///
/// As for parallel_for, when and where a node is called is left open. Above a node that throws none is
/// called; the others are, and the exception of the smallest index is thrown on.
void parallel_tree(std::span<const int> parent, int threads, const std::function<void(std::size_t)>& body);

}  // namespace fretwork::base
