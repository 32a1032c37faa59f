// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/detail/canonical_form.hpp>

#include <nauty/nauty.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace fretwork::pattern::detail {
namespace {

/// The memory that nauty keeps for each thread and frees only on request.
struct MemoryOfThread {
    MemoryOfThread() = default;
    MemoryOfThread(const MemoryOfThread&) = delete;
    MemoryOfThread& operator=(const MemoryOfThread&) = delete;
    ~MemoryOfThread() {
        nauty_freedyn();
        nautil_freedyn();
        naugraph_freedyn();
    }
};

/// The arrays of nauty's interface, each of the right length.
struct Workspace {
    explicit Workspace(int node_count, int words)
        : graph(static_cast<std::size_t>(node_count) * static_cast<std::size_t>(words)),
          canonical(graph.size()),
          labels(node_count),
          cells(node_count),
          orbits(node_count) {}
    std::vector<setword> graph;
    std::vector<setword> canonical;
    std::vector<int> labels;
    std::vector<int> cells;
    std::vector<int> orbits;
};

/// Give interface nodes, which come first in a fan, the first colour, and all other nodes the second.
void colour(Workspace& work, int interface_node_count) {
    std::iota(work.labels.begin(), work.labels.end(), 0);
    std::fill(work.cells.begin(), work.cells.end(), 1);
    work.cells[interface_node_count - 1] = 0;
    work.cells.back() = 0;
}

}  // namespace

std::string canonical_form(const Fan& fan) {
    [[maybe_unused]] thread_local const MemoryOfThread memory;
    const int node_count = static_cast<int>(fan.nodes.size());
    const int words = SETWORDSNEEDED(node_count);
    Workspace work(node_count, words);
    for (const auto& [first, second] : fan.edges) {
        ADDONEEDGE(work.graph.data(), first.value, second.value, words);
    }
    colour(work, fan.interface_node_count);
    DEFAULTOPTIONS_GRAPH(options);
    options.getcanon = TRUE;
    options.defaultptn = FALSE;
    statsblk stats;
    densenauty(work.graph.data(), work.labels.data(), work.cells.data(), work.orbits.data(), &options, &stats,
               words, node_count, work.canonical.data());
    std::string form = std::to_string(fan.interface_node_count) + "/" + std::to_string(node_count) + ":";
    return form.append(reinterpret_cast<const char*>(work.canonical.data()),
                       work.canonical.size() * sizeof(setword));
}

}  // namespace fretwork::pattern::detail
