// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/sparse/dissection.hpp>
#include <fretwork/mechanics/sparse/node_graph.hpp>

#include <cholmod.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <initializer_list>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace fretwork::mechanics::sparse {
namespace {

/// A session of CHOLMOD, from its start to its finish.
struct Cholmod {
    Cholmod() { cholmod_start(&common); }
    Cholmod(const Cholmod&) = delete;
    Cholmod& operator=(const Cholmod&) = delete;
    ~Cholmod() { cholmod_finish(&common); }
    cholmod_common common;
};

/// The numbers of nodes above which nested dissection pays off in addition to minimum degree. The first is
/// for dissection by places. The second is for unknown places: dissection by the graph takes twenty times as
/// long.
constexpr std::size_t kSomeNodes = 500;
constexpr std::size_t kManyNodes = 20000;

struct Pattern {
    std::vector<int> start;
    std::vector<int> row;
    std::vector<int> given{};  ///< a given order as a candidate; empty: none
};

/// The upper triangle of the graph's matrix for the nodes that take part, with their new numbers. The
/// diagonal is included, because CHOLMOD takes a node without it as a dense row.
Pattern upper_pattern(const NodeGraph& graph, const std::vector<int>& nodes, const std::vector<int>& number) {
    Pattern pattern{{0}, {}};
    pattern.row.reserve(graph.neighbour.size() / 2 + nodes.size());
    for (std::size_t column = 0; column < nodes.size(); ++column) {
        const std::size_t node = nodes[column];
        for (int k = graph.start[node]; k < graph.start[node + 1]; ++k) {
            const int other = number[graph.neighbour[k]];
            if (other >= 0 && other < static_cast<int>(column)) pattern.row.push_back(other);
        }
        pattern.row.push_back(static_cast<int>(column));
        pattern.start.push_back(static_cast<int>(pattern.row.size()));
    }
    return pattern;
}

struct Order {
    std::vector<int> nodes;
    double multiplications = 0.0;  ///< number of multiplications of a factorization
};

/// The order that methods of CHOLMOD give, post-ordered. From several methods, CHOLMOD takes the order with
/// the least fill.
Order order_by(Pattern& pattern, std::initializer_list<int> methods) {
    const std::size_t size = pattern.start.size() - 1;
    Cholmod cholmod;
    for (const int method : methods) cholmod.common.method[cholmod.common.nmethods++].ordering = method;
    cholmod.common.postorder = 1;
    cholmod.common.supernodal = CHOLMOD_SIMPLICIAL;
    cholmod_sparse matrix{};
    matrix.nrow = matrix.ncol = size;
    matrix.nzmax = pattern.row.size();
    matrix.p = pattern.start.data();
    matrix.i = pattern.row.data();
    matrix.stype = 1;
    matrix.itype = CHOLMOD_INT;
    matrix.xtype = CHOLMOD_PATTERN;
    matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = matrix.packed = 1;
    int* given = pattern.given.empty() ? nullptr : pattern.given.data();
    cholmod_factor* factor = cholmod_analyze_p(&matrix, given, nullptr, 0, &cholmod.common);
    if (factor == nullptr) throw base::NumericalError("the nodes could not be ordered: out of memory");
    const int* permutation = static_cast<const int*>(factor->Perm);
    Order order{{permutation, permutation + size}, cholmod.common.fl};
    cholmod_free_factor(&factor, &cholmod.common);
    return order;
}

std::vector<int> permutation_of(Pattern& pattern) {
    const bool has_many_nodes = pattern.start.size() > kManyNodes;
    if (pattern.given.empty() && has_many_nodes) return order_by(pattern, {CHOLMOD_AMD, CHOLMOD_METIS}).nodes;
    Order order = order_by(pattern, {CHOLMOD_AMD});
    if (pattern.given.empty()) return std::move(order.nodes);
    Order by_place = order_by(pattern, {CHOLMOD_GIVEN});
    return std::move(by_place.multiplications < order.multiplications ? by_place.nodes : order.nodes);
}

/// Threads whose callers have stopped waiting for them. The program waits for these threads when it ends,
/// because a thread must not outlive the libraries that it uses.
class UnawaitedThreads {
  public:
    UnawaitedThreads() = default;
    UnawaitedThreads(const UnawaitedThreads&) = delete;
    UnawaitedThreads& operator=(const UnawaitedThreads&) = delete;
    ~UnawaitedThreads() {
        for (std::thread& thread : threads_) thread.join();
    }
    void take(std::thread thread) {
        const std::lock_guard lock(mutex_);
        threads_.push_back(std::move(thread));
    }

  private:
    std::mutex mutex_;
    std::vector<std::thread> threads_;
};

/// The permutation by CHOLMOD. The libraries that find orders cannot be stopped, so they run on a thread of
/// their own, which owns all its data. After a request to stop, the caller no longer waits for this thread.
/// If the machine refuses a thread, the caller's own thread computes the order, and stops afterwards.
std::vector<int> permutation_unless_stopped(Pattern pattern, const base::Control& control) {
    constexpr auto kPause = std::chrono::milliseconds(10);
    static UnawaitedThreads unawaited;
    const auto task = std::make_shared<std::packaged_task<std::vector<int>()>>(
        [own = std::move(pattern)]() mutable { return permutation_of(own); });
    std::future<std::vector<int>> order = task->get_future();
    std::thread thread;
    try {
        thread = std::thread([task] { (*task)(); });
    } catch (const std::system_error&) {
        (*task)();
        control.check();
        return order.get();
    }
    while (order.wait_for(kPause) != std::future_status::ready) {
        if (!control.stop.stop_requested()) continue;
        unawaited.take(std::move(thread));
        throw base::Stopped();
    }
    thread.join();
    return order.get();
}

}  // namespace

NodeGraph node_graph(int nodes, Cliques cliques) {
    std::vector<std::pair<int, int>> pairs;
    for (std::size_t clique = 0; clique < cliques.size(); ++clique) {
        for (const int a : cliques[clique]) {
            for (const int b : cliques[clique]) {
                if (a != b) pairs.emplace_back(a, b);
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    NodeGraph graph;
    graph.nodes = nodes;
    graph.cliques = std::move(cliques);
    graph.start.assign(nodes + 1, 0);
    for (const auto& pair : pairs) ++graph.start[pair.first + 1];
    for (std::size_t i = 1; i < graph.start.size(); ++i) graph.start[i] += graph.start[i - 1];
    graph.neighbour.reserve(pairs.size());
    for (const auto& pair : pairs) graph.neighbour.push_back(pair.second);
    return graph;
}

std::vector<int> elimination_order(const NodeGraph& graph, std::span<const Components> free,
                                   const base::Control& control) {
    std::vector<int> nodes;
    std::vector<int> number(graph.nodes, -1);
    for (int i = 0; i < graph.nodes; ++i) {
        if (free[i] == Components{}) continue;
        number[i] = static_cast<int>(nodes.size());
        nodes.push_back(i);
    }
    if (nodes.empty()) return {};
    Pattern pattern = upper_pattern(graph, nodes, number);
    if (!graph.places.empty() && nodes.size() > kSomeNodes) {
        std::vector<bool> takes_part(graph.nodes);
        for (const int node : nodes) takes_part[node] = true;
        pattern.given = dissection_order(graph, takes_part, control);
        for (int& node : pattern.given) node = number[node];
    }
    std::vector<int> order = nodes.size() > kManyNodes && control.stop.stop_possible()
                                 ? permutation_unless_stopped(std::move(pattern), control)
                                 : permutation_of(pattern);
    for (int& place : order) place = nodes[place];
    return order;
}

}  // namespace fretwork::mechanics::sparse
